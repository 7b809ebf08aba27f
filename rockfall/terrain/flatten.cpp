#include "rockfall/terrain/flatten.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>

#include "rockfall/terrain/hilbert.hpp"

namespace rockfall {
namespace {

constexpr std::uint32_t unused = 0xFFFFFFFFU;

/// Old index to new index, for an order that lists old indices.
std::vector<std::uint32_t> rank_of(std::span<const std::uint32_t> order, std::size_t size) {
    std::vector<std::uint32_t> rank(size, unused);
    for (std::size_t i = 0; i < order.size(); ++i) {
        rank[order[i]] = static_cast<std::uint32_t>(i);
    }
    return rank;
}

/// Indices of the vertices that some triangle uses, along the curve.
std::vector<std::uint32_t> vertex_order(std::span<const Vertex> vertices,
                                        std::span<const Triangle> triangles) {
    std::vector<char> is_used(vertices.size(), 0);
    for (const Triangle& triangle : triangles) {
        for (const std::uint32_t corner : triangle.corners) {
            is_used[corner] = 1;
        }
    }
    std::vector<std::uint32_t> used;
    std::vector<Eigen::Vector2d> places;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (is_used[i] != 0) {
            used.push_back(static_cast<std::uint32_t>(i));
            places.emplace_back(vertices[i].x_m, vertices[i].y_m);
        }
    }
    std::vector<std::uint32_t> order = hilbert_order(places);
    for (std::uint32_t& index : order) {
        index = used[index];
    }
    return order;
}

std::vector<std::uint32_t> triangle_order(std::span<const Vertex> vertices,
                                          std::span<const Triangle> triangles) {
    std::vector<Eigen::Vector2d> centroids;
    centroids.reserve(triangles.size());
    for (const Triangle& triangle : triangles) {
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        for (const std::uint32_t corner : triangle.corners) {
            sum += Eigen::Vector2d{vertices[corner].x_m, vertices[corner].y_m};
        }
        centroids.emplace_back(sum / 3.0);
    }
    return hilbert_order(centroids);
}

}  // namespace

Terrain along_hilbert_curve(const Eigen::Vector2d& origin_m, std::span<const Vertex> vertices,
                            std::span<const Triangle> triangles) {
    const std::vector<std::uint32_t> old_vertices = vertex_order(vertices, triangles);
    const std::vector<std::uint32_t> old_triangles = triangle_order(vertices, triangles);
    const std::vector<std::uint32_t> new_vertex = rank_of(old_vertices, vertices.size());
    const std::vector<std::uint32_t> new_triangle = rank_of(old_triangles, triangles.size());

    std::vector<Vertex> ordered_vertices;
    ordered_vertices.reserve(old_vertices.size());
    for (const std::uint32_t old : old_vertices) {
        ordered_vertices.push_back(vertices[old]);
    }
    std::vector<Triangle> ordered_triangles;
    ordered_triangles.reserve(old_triangles.size());
    for (const std::uint32_t old : old_triangles) {
        Triangle triangle = triangles[old];
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t neighbour = triangle.neighbours[i];
            triangle.corners[i] = new_vertex[triangle.corners[i]];
            triangle.neighbours[i] = neighbour == no_triangle ? no_triangle : new_triangle[neighbour];
        }
        ordered_triangles.push_back(triangle);
    }
    return Terrain{origin_m, std::move(ordered_vertices), std::move(ordered_triangles)};
}

}  // namespace rockfall
