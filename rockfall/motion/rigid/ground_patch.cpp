#include "rockfall/motion/rigid/ground_patch.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "rockfall/solids/ground_contact.hpp"

namespace rockfall::rigid {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d place_of_vertex(const Terrain& terrain, std::uint32_t number) {
    const Vertex& v = terrain.vertices()[number];
    return {v.x_m, v.y_m, v.z_m};
}

Vector3d normal_of_triangle(const Terrain& terrain, std::uint32_t number) {
    const Triangle& t = terrain.triangles()[number];
    const Vector3d a = place_of_vertex(terrain, t.corners[0]);
    return (place_of_vertex(terrain, t.corners[1]) - a)
        .cross(place_of_vertex(terrain, t.corners[2]) - a)
        .normalized();
}

}  // namespace

void GroundPatch::add_triangle(const Terrain& terrain, std::uint32_t number) {
    const Triangle& t = terrain.triangles()[number];
    NearTriangle near;
    near.number = number;
    for (int k = 0; k < 3; ++k) {
        near.corners[k] = t.corners[k];
        near.corners_m[k] = place_of_vertex(terrain, t.corners[k]);
    }
    near.normal =
        (near.corners_m[1] - near.corners_m[0]).cross(near.corners_m[2] - near.corners_m[0]).normalized();
    near.offset_m = near.normal.dot(near.corners_m[0]);
    for (int k = 0; k < 3; ++k) {
        // The same number from both sides of an edge, up to its sign: no point falls between two triangles.
        const bool forward = t.corners[k] < t.corners[(k + 1) % 3];
        const Vector3d& a = near.corners_m[forward ? k : (k + 1) % 3];
        const Vector3d& b = near.corners_m[forward ? (k + 1) % 3 : k];
        const Vector2d inwards = Vector2d{a.y() - b.y(), b.x() - a.x()}.normalized();
        const Vector3d line{inwards.x(), inwards.y(), -(inwards.x() * a.x() + inwards.y() * a.y())};
        near.edges[k] = forward ? line : Vector3d{-line};
    }
    triangles_.push_back(near);
}

void GroundPatch::gather(const Terrain& terrain, std::uint32_t under, const Vector2d& centre_m,
                         double radius_m, PatchMarks& memory) {
    centre_m_ = centre_m;
    radius_m_ = radius_m;
    triangles_.clear();
    each_triangle_near(terrain, under, centre_m, centre_m, radius_m, memory,
                       [&](std::uint32_t number, const Triangle&) { add_triangle(terrain, number); });
    find_ridges(terrain);
}

void GroundPatch::find_ridges(const Terrain& terrain) {
    ridges_.clear();
    peaks_.clear();
    neighbours_.clear();
    ridge_ends_.clear();
    for (const NearTriangle& near : triangles_) {
        const Triangle& t = terrain.triangles()[near.number];
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t beyond = t.neighbours[k];
            if (beyond == no_triangle) {
                continue;
            }
            const Vector3d& from_m = near.corners_m[k];
            const Vector3d along_m = near.corners_m[(k + 1) % 3] - from_m;
            const Vector3d beyond_normal = normal_of_triangle(terrain, beyond);
            if (beyond_normal.dot(along_m.cross(near.normal)) <= solids::parallel_sine * along_m.norm()) {
                continue;
            }
            if (near.number < beyond ||
                std::none_of(triangles_.begin(), triangles_.end(),
                             [&](const auto& other) { return other.number == beyond; })) {
                ridges_.push_back({from_m, along_m, near.normal, beyond_normal, near.number});
            }
            ridge_ends_.push_back(near.corners[k]);
            ridge_ends_.push_back(near.corners[(k + 1) % 3]);
        }
    }
    std::sort(ridge_ends_.begin(), ridge_ends_.end());
    ridge_ends_.erase(std::unique(ridge_ends_.begin(), ridge_ends_.end()), ridge_ends_.end());
    for (const std::uint32_t vertex : ridge_ends_) {
        NearPeak peak{place_of_vertex(terrain, vertex), static_cast<std::uint32_t>(neighbours_.size()), 0,
                      no_triangle};
        for (const NearTriangle& near : triangles_) {
            for (int k = 0; k < 3; ++k) {
                if (near.corners[k] == vertex) {
                    neighbours_.push_back(near.corners_m[(k + 1) % 3]);
                    neighbours_.push_back(near.corners_m[(k + 2) % 3]);
                    peak.triangle = near.number;
                }
            }
        }
        peak.neighbours = static_cast<std::uint32_t>(neighbours_.size()) - peak.first_neighbour;
        peaks_.push_back(peak);
    }
}

}  // namespace rockfall::rigid
