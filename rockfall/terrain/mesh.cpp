#include "rockfall/terrain/mesh.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <queue>
#include <utility>

#include "rockfall/terrain/breaklines.hpp"
#include "rockfall/terrain/flatten.hpp"
#include "rockfall/terrain/grid_ground.hpp"
#include "rockfall/terrain/grid_mesh.hpp"
#include "rockfall/terrain/vertical_error.hpp"

namespace rockfall {
namespace {

/// Larger grids are triangulated without a search: it needs four times the memory.
constexpr std::size_t most_searched_cells = std::size_t{1} << 22U;

struct FaceInfo {
    std::uint32_t triangle = no_triangle;  ///< place in the list of triangles that is handed on
    VerticalError worst;                   ///< the cell to insert next, while a grid is being thinned
};

// The plan alone decides a Delaunay triangulation of terrain, so it is plane; heights stay outside, under the
// index that each vertex carries. That leaves CGAL's static filters two coordinates and two thirds of the
// memory.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;
using Face = Delaunay::Face_handle;
using ConstrainedFaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, FaceBase>;
using Constrained = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, ConstrainedFaceBase>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;
using IndexedPoint = std::pair<Kernel::Point_2, std::uint32_t>;

template <class AnyFace>
std::array<std::uint32_t, 3> corners_of(AnyFace face) {
    return {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
}

/// The finite triangles that `is_terrain` accepts, with their neighbours.
template <class Mesh, class IsTerrain>
std::vector<Triangle> flat_triangles(const Mesh& mesh, IsTerrain is_terrain) {
    using AnyFace = typename Mesh::Face_handle;
    std::vector<AnyFace> faces;
    for (const AnyFace face : mesh.finite_face_handles()) {
        if (is_terrain(corners_of(face))) {
            face->info().triangle = static_cast<std::uint32_t>(faces.size());
            faces.push_back(face);
        }
    }
    std::vector<Triangle> triangles(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
        for (int edge = 0; edge < 3; ++edge) {
            // CGAL's neighbour k lies opposite to corner k, ours across the edge that begins at corner k.
            triangles[i].corners[edge] = faces[i]->vertex(edge)->info();
            triangles[i].neighbours[edge] = faces[i]->neighbor((edge + 2) % 3)->info().triangle;
        }
    }
    return triangles;
}

Eigen::Vector2d whole_metres_below(const Eigen::Vector2d& corner_m) {
    return corner_m.array().floor();
}

/// Cell centres in units of the cell height, row 0 in the north: whole numbers for square cells, on which the
/// many cocircular points of a grid need no exact arithmetic and the choice of diagonals does not depend on
/// rounding.
Kernel::Point_2 plan_point(const config::GridFrame& frame, config::Cell cell) {
    return {cell.column * (frame.cell_width_m / frame.cell_height_m), static_cast<double>(-cell.row)};
}

Delaunay with_every_cell(const config::Raster<double>& heights) {
    std::vector<IndexedPoint> points;
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        if (std::isfinite(heights.values[i])) {
            points.emplace_back(plan_point(heights.frame, heights.frame.cell_of(i)),
                                static_cast<std::uint32_t>(i));
        }
    }
    return Delaunay{points.begin(), points.end()};
}

bool is_ground(const config::Raster<double>& heights, const std::array<std::uint32_t, 3>& corners) {
    const config::GridFrame& frame = heights.frame;
    return lies_on_ground(heights, frame.cell_of(corners[0]), frame.cell_of(corners[1]),
                          frame.cell_of(corners[2]));
}

/// Greedy insertion (Garland & Heckbert 1995): the cell with the largest vertical error comes next, until
/// none is above the tolerance. Each face knows its worst cell; only the faces around a new vertex are looked
/// through again.
class Thinning {
public:
    Thinning(const config::Raster<double>& heights, double tolerance_m)
        : heights_{heights}, tolerance_m_{tolerance_m} {
        std::vector<IndexedPoint> points;
        for (const config::Cell cell : outline_cells(heights)) {
            points.emplace_back(plan_point(heights.frame, cell), index_of(cell));
        }
        mesh_.insert(points.begin(), points.end());
        for (const Face face : mesh_.finite_face_handles()) {
            measure(face);
        }
    }

    Delaunay thinned() && {
        while (!candidates_.empty()) {
            const Candidate next = candidates_.top();
            candidates_.pop();
            const VerticalError& worst = next.face->info().worst;
            if (worst.error_m == next.error_m && index_of(worst.cell) == next.cell) {
                insert(next);
            }
        }
        return std::move(mesh_);
    }

private:
    struct Candidate {
        double error_m;
        std::uint32_t cell;
        Face face;
        /// Smaller errors stand behind larger ones; of equal ones the north-western cell comes first.
        bool operator<(const Candidate& other) const {
            return error_m != other.error_m ? error_m < other.error_m : cell > other.cell;
        }
    };

    [[nodiscard]] std::uint32_t index_of(config::Cell cell) const {
        return static_cast<std::uint32_t>(heights_.frame.index(cell));
    }

    void measure(Face face) {
        face->info().worst = {};
        const std::array<std::uint32_t, 3> corners = corners_of(face);
        if (!is_ground(heights_, corners)) {
            return;
        }
        const config::GridFrame& frame = heights_.frame;
        const VerticalError worst = largest_vertical_error(
            heights_, {frame.cell_of(corners[0]), frame.cell_of(corners[1]), frame.cell_of(corners[2])});
        if (worst.error_m > tolerance_m_) {
            face->info().worst = worst;
            candidates_.push({worst.error_m, index_of(worst.cell), face});
        }
    }

    void insert(const Candidate& candidate) {
        const config::Cell cell = candidate.face->info().worst.cell;
        const Delaunay::Vertex_handle vertex = mesh_.insert(plan_point(heights_.frame, cell), candidate.face);
        vertex->info() = candidate.cell;
        // All that changes in a Delaunay triangulation lies around the new vertex.
        Delaunay::Face_circulator face = mesh_.incident_faces(vertex);
        const Delaunay::Face_circulator first = face;
        do {
            if (!mesh_.is_infinite(face)) {
                measure(face);
            }
        } while (++face != first);
    }

    const config::Raster<double>& heights_;
    double tolerance_m_;
    Delaunay mesh_;
    std::priority_queue<Candidate> candidates_;
};

std::vector<Vertex> vertices_of(const config::Raster<double>& heights, const Eigen::Vector2d& origin_m) {
    config::GridFrame frame = heights.frame;
    frame.x_west_m -= origin_m.x();
    frame.y_south_m -= origin_m.y();
    std::vector<Vertex> vertices;
    vertices.reserve(heights.values.size());
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        const config::Cell cell = frame.cell_of(i);
        vertices.push_back({frame.x_centre_m(cell.column), frame.y_centre_m(cell.row), heights.values[i]});
    }
    return vertices;
}

/// Neither with an edge that is too long nor thinner than a billionth of its longest edge.
bool is_plausible(const std::array<Vertex, 3>& corners, double longest_edge_m) {
    const auto [a, b, c] = corners;
    const Eigen::Vector2d ab{b.x_m - a.x_m, b.y_m - a.y_m};
    const Eigen::Vector2d bc{c.x_m - b.x_m, c.y_m - b.y_m};
    const Eigen::Vector2d ca{a.x_m - c.x_m, a.y_m - c.y_m};
    const double longest_m2 = std::max({ab.squaredNorm(), bc.squaredNorm(), ca.squaredNorm()});
    const double area2_m2 = ca.x() * ab.y() - ca.y() * ab.x();
    return area2_m2 > 1e-9 * longest_m2 &&
           (longest_edge_m <= 0.0 || longest_m2 <= longest_edge_m * longest_edge_m);
}

/// Scattered points without those that are not finite; of those at one plan position only the first.
struct PlacedPoints {
    Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();
    std::vector<Vertex> vertices;
    std::vector<IndexedPoint> plan;
    std::vector<std::uint32_t> vertex_of;  ///< of each given point; no_triangle: none

    explicit PlacedPoints(std::span<const Eigen::Vector3d> points) : vertex_of(points.size(), no_triangle) {
        std::vector<std::uint32_t> order(points.size());
        std::iota(order.begin(), order.end(), 0U);
        std::erase_if(order, [&](std::uint32_t i) { return !points[i].allFinite(); });
        const auto place = [&](std::uint32_t i) { return std::pair{points[i].x(), points[i].y()}; };
        std::stable_sort(order.begin(), order.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
        if (order.empty()) {
            return;
        }
        Eigen::Vector2d corner_m = points[order.front()].head<2>();
        for (const std::uint32_t i : order) {
            corner_m = corner_m.cwiseMin(points[i].head<2>());
        }
        origin_m = whole_metres_below(corner_m);
        for (std::size_t k = 0; k < order.size(); ++k) {
            const std::uint32_t i = order[k];
            if (k == 0 || place(i) != place(order[k - 1])) {
                const Eigen::Vector2d place_m = points[i].head<2>() - origin_m;
                plan.emplace_back(Kernel::Point_2{place_m.x(), place_m.y()},
                                  static_cast<std::uint32_t>(vertices.size()));
                vertices.push_back({place_m.x(), place_m.y(), points[i].z()});
            }
            vertex_of[i] = static_cast<std::uint32_t>(vertices.size() - 1);
        }
    }

    template <class Mesh>
    [[nodiscard]] Terrain terrain(const Mesh& mesh, double longest_edge_m) const {
        if (vertices.empty()) {
            return Terrain{Eigen::Vector2d::Zero(), {}, {}};
        }
        const std::vector<Triangle> triangles =
            flat_triangles(mesh, [&](const std::array<std::uint32_t, 3>& corners) {
                return is_plausible({vertices[corners[0]], vertices[corners[1]], vertices[corners[2]]},
                                    longest_edge_m);
            });
        return along_hilbert_curve(origin_m, vertices, triangles);
    }
};

}  // namespace

Terrain triangulate(const config::Raster<double>& heights, double vertical_tolerance_m) {
    // A search gives the same triangles, but begins them at the corners that it happened to come from, and
    // the last bits of a fall follow from that: results of grids of usual size keep their bytes.
    if (!(vertical_tolerance_m > 0.0) && heights.values.size() > most_searched_cells) {
        return mesh_of_every_cell(heights);
    }
    const Delaunay mesh = vertical_tolerance_m > 0.0 ? Thinning{heights, vertical_tolerance_m}.thinned()
                                                     : with_every_cell(heights);
    const std::vector<Triangle> triangles = flat_triangles(
        mesh,
        [&heights](const std::array<std::uint32_t, 3>& corners) { return is_ground(heights, corners); });
    const Eigen::Vector2d origin_m = whole_metres_below({heights.frame.x_west_m, heights.frame.y_south_m});
    return along_hilbert_curve(origin_m, vertices_of(heights, origin_m), triangles);
}

Terrain triangulate(std::span<const Eigen::Vector3d> points, double longest_edge_m) {
    const PlacedPoints placed{points};
    const Delaunay mesh{placed.plan.begin(), placed.plan.end()};
    return placed.terrain(mesh, longest_edge_m);
}

Terrain triangulate(std::span<const Eigen::Vector3d> points, std::span<const PointPair> lines,
                    double longest_edge_m) {
    const PlacedPoints placed{points};
    Constrained mesh;
    std::vector<Constrained::Vertex_handle> handles;
    for (const auto& [place, index] : placed.plan) {
        handles.push_back(mesh.insert(place));
        handles.back()->info() = index;
    }
    for (const auto& [from, to] : lines) {
        const std::uint32_t a = placed.vertex_of[from];
        const std::uint32_t b = placed.vertex_of[to];
        if (a != b && a != no_triangle && b != no_triangle) {
            mesh.insert_constraint(handles[a], handles[b]);
        }
    }
    return placed.terrain(mesh, longest_edge_m);
}

}  // namespace rockfall
