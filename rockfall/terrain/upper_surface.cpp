#include "rockfall/terrain/upper_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "config/grid/raster.hpp"
#include "rockfall/terrain/breaklines.hpp"
#include "rockfall/terrain/joining.hpp"
#include "rockfall/terrain/plan.hpp"
#include "rockfall/terrain/upright.hpp"

namespace rockfall {
namespace {

/// Heights that differ by less are one.
constexpr double same_height_m = 1e-6;

/// A face in plan, corners counter-clockwise, relative to the first vertex of the network.
struct PlanFace {
    std::array<Eigen::Vector2d, 3> corners_m;
    Eigen::Vector3d plane = Eigen::Vector3d::Zero();  ///< height = x p.x + y p.y + z
    double area_m2 = 0.0;                             ///< of the plan

    [[nodiscard]] double height_m(const Eigen::Vector2d& place_m) const {
        return plane.x() * place_m.x() + plane.y() * place_m.y() + plane.z();
    }
    [[nodiscard]] Eigen::Vector2d low_m() const {
        return corners_m[0].cwiseMin(corners_m[1]).cwiseMin(corners_m[2]);
    }
    [[nodiscard]] Eigen::Vector2d high_m() const {
        return corners_m[0].cwiseMax(corners_m[1]).cwiseMax(corners_m[2]);
    }
    /// Inside, at least this far from the edges.
    [[nodiscard]] bool holds(const Eigen::Vector2d& place_m, double margin_m) const {
        for (std::size_t i = 0; i < 3; ++i) {
            const Eigen::Vector2d edge = corners_m[(i + 1) % 3] - corners_m[i];
            if (cross_in_plan(edge, place_m - corners_m[i]) < margin_m * edge.norm()) {
                return false;
            }
        }
        return true;
    }
};

PlanFace plan_of(const Tin& tin, const TinFace& face, const Eigen::Vector3d& origin_m) {
    std::array<Eigen::Vector3d, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
        p[i] = tin.vertices_m[face.corners[i]] - origin_m;
    }
    Eigen::Vector3d area2 = (p[1] - p[0]).cross(p[2] - p[0]);
    if (area2.z() < 0.0) {
        std::swap(p[1], p[2]);
        area2 = -area2;
    }
    PlanFace plan;
    plan.corners_m = {p[0].head<2>(), p[1].head<2>(), p[2].head<2>()};
    plan.area_m2 = 0.5 * area2.z();
    if (area2.z() > 0.0) {
        const double x = -area2.x() / area2.z();
        const double y = -area2.y() / area2.z();
        plan.plane = {x, y, p[0].z() - x * p[0].x() - y * p[0].y()};
    }
    return plan;
}

/// Middle of the common part of two faces in plan; nothing where they share no area worth the name. Clips one
/// by the edges of the other (Sutherland & Hodgman 1974).
std::optional<Eigen::Vector2d> middle_of_overlap(const PlanFace& one, const PlanFace& other) {
    std::vector<Eigen::Vector2d> ring{one.corners_m.begin(), one.corners_m.end()};
    for (std::size_t i = 0; i < 3 && !ring.empty(); ++i) {
        const Eigen::Vector2d& from = other.corners_m[i];
        const Eigen::Vector2d edge = other.corners_m[(i + 1) % 3] - from;
        std::vector<Eigen::Vector2d> kept;
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Eigen::Vector2d& here = ring[k];
            const Eigen::Vector2d& next = ring[(k + 1) % ring.size()];
            const double side = cross_in_plan(edge, here - from);
            const double next_side = cross_in_plan(edge, next - from);
            if (side >= 0.0) {
                kept.push_back(here);
            }
            if ((side > 0.0 && next_side < 0.0) || (side < 0.0 && next_side > 0.0)) {
                kept.emplace_back(here + side / (side - next_side) * (next - here));
            }
        }
        ring = std::move(kept);
    }
    double area2 = 0.0;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
        const double part = cross_in_plan(ring[k] - ring[0], ring[k + 1] - ring[0]);
        area2 += part;
        sum += part / 3.0 * (ring[0] + ring[k] + ring[k + 1]);
    }
    constexpr double least_share = 1e-6;  // less is what neighbours share by rounding
    if (!(0.5 * area2 > least_share * std::min(one.area_m2, other.area_m2))) {
        return std::nullopt;
    }
    return sum / area2;
}

/// Faces by the square cells that they reach into.
class PlanIndex {
public:
    explicit PlanIndex(std::span<const PlanFace> faces) : faces_{faces} {
        Eigen::Vector2d low_m = faces.front().low_m();
        Eigen::Vector2d high_m = faces.front().high_m();
        double widths_m = 0.0;
        for (const PlanFace& face : faces) {
            low_m = low_m.cwiseMin(face.low_m());
            high_m = high_m.cwiseMax(face.high_m());
            widths_m += (face.high_m() - face.low_m()).maxCoeff();
        }
        const double count = static_cast<double>(faces.size());
        const Eigen::Vector2d extent_m = high_m - low_m;
        const double width_m = std::max(
            {2.0 * widths_m / count, std::sqrt(extent_m.prod() / count), extent_m.maxCoeff() / count, 1e-3});
        frame_ = {.columns = static_cast<int>(extent_m.x() / width_m) + 1,
                  .rows = static_cast<int>(extent_m.y() / width_m) + 1,
                  .x_west_m = low_m.x(),
                  .y_south_m = low_m.y(),
                  .cell_width_m = width_m,
                  .cell_height_m = width_m};
        cells_.resize(frame_.size());
        for (std::uint32_t f = 0; f < faces.size(); ++f) {
            for_each_cell(faces[f].low_m(), faces[f].high_m(),
                          [&](std::size_t cell) { cells_[cell].push_back(f); });
        }
    }

    /// The faces that may reach into the rectangle of another, rising, each once.
    void near(const PlanFace& face, std::vector<std::uint32_t>& found) const {
        found.clear();
        for_each_cell(face.low_m(), face.high_m(), [&](std::size_t cell) {
            found.insert(found.end(), cells_[cell].begin(), cells_[cell].end());
        });
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
    }

    /// The uppermost face over a place; nothing where none lies.
    [[nodiscard]] std::optional<std::uint32_t> uppermost(const Eigen::Vector2d& place_m) const {
        std::optional<std::uint32_t> top;
        for_each_cell(place_m, place_m, [&](std::size_t cell) {
            for (const std::uint32_t f : cells_[cell]) {
                if (faces_[f].area_m2 > 0.0 && faces_[f].holds(place_m, 0.0) &&
                    (!top || faces_[f].height_m(place_m) > faces_[*top].height_m(place_m))) {
                    top = f;
                }
            }
        });
        return top;
    }

private:
    template <class Visit>
    void for_each_cell(const Eigen::Vector2d& low_m, const Eigen::Vector2d& high_m, Visit visit) const {
        const auto clamped = [](int value, int count) { return std::clamp(value, 0, count - 1); };
        const config::Cell south_west = frame_.cell_at(low_m.x(), low_m.y());
        const config::Cell north_east = frame_.cell_at(high_m.x(), high_m.y());
        for (int row = clamped(north_east.row, frame_.rows); row <= clamped(south_west.row, frame_.rows);
             ++row) {
            for (int column = clamped(south_west.column, frame_.columns);
                 column <= clamped(north_east.column, frame_.columns); ++column) {
                visit(frame_.index({column, row}));
            }
        }
    }

    std::span<const PlanFace> faces_;
    config::GridFrame frame_;
    std::vector<std::vector<std::uint32_t>> cells_;
};

/// Which faces lie below another one.
std::vector<bool> covered_faces(std::span<const PlanFace> faces, const PlanIndex& index) {
    std::vector<bool> covered(faces.size(), false);
    std::vector<std::uint32_t> near;
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        if (!(faces[f].area_m2 > 0.0)) {
            covered[f] = true;  // seen from above it is a line
            continue;
        }
        index.near(faces[f], near);
        for (const std::uint32_t other : near) {
            if (other <= f || !(faces[other].area_m2 > 0.0)) {
                continue;
            }
            if (const auto middle_m = middle_of_overlap(faces[f], faces[other])) {
                const double above_m = faces[f].height_m(*middle_m) - faces[other].height_m(*middle_m);
                covered[above_m > -same_height_m ? other : f] = true;
            }
        }
    }
    return covered;
}

/// Given faces after joining and leaning, each with its number in the list.
struct Numbered {
    Tin tin;
    std::vector<std::size_t> number_of;
};

Numbered joined_and_leaned(const Tin& given) {
    Tin numbered = given;
    for (std::size_t f = 0; f < given.faces.size(); ++f) {
        numbered.faces[f].surface = static_cast<std::uint32_t>(f);
    }
    TinChanges changes;
    join_vertices(numbered, changes);
    Numbered result;
    for (TinFace& face : numbered.faces) {
        result.number_of.push_back(face.surface);
        face.surface = given.faces[face.surface].surface;
    }
    result.tin = std::move(numbered);
    drop_unused_vertices(result.tin);
    turn_over_if_all_look_down(result.tin, changes);
    lean_upright_faces(result.tin, changes);
    return result;
}

/// What is seen from above, as points and edges to be triangulated.
struct Seen {
    std::vector<Eigen::Vector3d> points_m;
    std::vector<PointPair> edges;  ///< of the faces that stay
    std::size_t faces = 0;         ///< that stay
};

Seen seen_of(const Tin& tin, std::span<const PlanFace> plans, const PlanIndex& index,
             const std::vector<bool>& covered, const Eigen::Vector3d& origin_m) {
    std::vector<bool> is_seen(tin.vertices_m.size(), false);
    std::set<PointPair> edges;
    Seen seen;
    for (std::size_t f = 0; f < tin.faces.size(); ++f) {
        const auto& corners = tin.faces[f].corners;
        seen.faces += covered[f] ? 0 : 1;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t next = corners[(i + 1) % 3];
            if (!covered[f]) {
                is_seen[corners[i]] = true;
                edges.insert({std::min(corners[i], next), std::max(corners[i], next)});
                continue;
            }
            const Eigen::Vector3d vertex_m = tin.vertices_m[corners[i]] - origin_m;
            const auto top = index.uppermost(vertex_m.head<2>());
            if (!top || plans[*top].height_m(vertex_m.head<2>()) < vertex_m.z() + same_height_m) {
                is_seen[corners[i]] = true;
            }
        }
    }
    std::vector<std::uint32_t> place_of(tin.vertices_m.size(), no_triangle);
    for (std::uint32_t v = 0; v < tin.vertices_m.size(); ++v) {
        if (is_seen[v]) {
            place_of[v] = static_cast<std::uint32_t>(seen.points_m.size());
            seen.points_m.push_back(tin.vertices_m[v]);
        }
    }
    for (const PointPair& edge : edges) {
        seen.edges.push_back({place_of[edge[0]], place_of[edge[1]]});
    }
    return seen;
}

/// A terrain as faces, without those over whose middle no given face lies.
Tin faces_over(const Terrain& terrain, const Tin& given, const PlanIndex& index,
               const Eigen::Vector3d& origin_m) {
    Tin tin;
    for (const Vertex& vertex : terrain.vertices()) {
        tin.vertices_m.emplace_back(vertex.x_m + terrain.origin_m().x(), vertex.y_m + terrain.origin_m().y(),
                                    vertex.z_m);
    }
    for (const Triangle& triangle : terrain.triangles()) {
        const auto& [a, b, c] = triangle.corners;
        const Eigen::Vector3d middle_m =
            (tin.vertices_m[a] + tin.vertices_m[b] + tin.vertices_m[c]) / 3.0 - origin_m;
        if (const auto top = index.uppermost(middle_m.head<2>())) {
            tin.faces.push_back({{a, b, c}, given.faces[*top].surface});
        }
    }
    return tin;
}

}  // namespace

UpperSurface upper_surface(const Tin& given) {
    const auto [tin, number_of] = joined_and_leaned(given);
    UpperSurface result;
    if (tin.faces.empty()) {
        return result;
    }
    const Eigen::Vector3d origin_m = tin.vertices_m.front();
    std::vector<PlanFace> plans;
    for (const TinFace& face : tin.faces) {
        plans.push_back(plan_of(tin, face, origin_m));
    }
    const PlanIndex index{plans};
    const std::vector<bool> covered = covered_faces(plans, index);
    for (std::size_t f = 0; f < tin.faces.size(); ++f) {
        if (covered[f]) {
            const auto& [a, b, c] = tin.faces[f].corners;
            result.left_out.push_back(
                {number_of[f], {tin.vertices_m[a], tin.vertices_m[b], tin.vertices_m[c]}});
        }
    }
    const Seen seen = seen_of(tin, plans, index, covered, origin_m);
    result.tin = faces_over(triangulate(seen.points_m, seen.edges, 0.0), tin, index, origin_m);
    result.filled = result.tin.faces.size() - std::min(seen.faces, result.tin.faces.size());
    return result;
}

}  // namespace rockfall
