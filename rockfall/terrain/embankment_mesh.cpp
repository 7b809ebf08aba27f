// The mesh of a terrain with an embankment.

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

#include "rockfall/terrain/breaklines.hpp"
#include "rockfall/terrain/embankment.hpp"
#include "rockfall/terrain/flatten.hpp"

namespace rockfall {
namespace {

using PlanCorner = Eigen::Vector2d;

double turn_about(const PlanCorner& a, const PlanCorner& b, const PlanCorner& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

double distance_to_side_m(const PlanCorner& point, const PlanCorner& a, const PlanCorner& b) {
    const PlanCorner side = b - a;
    const double share = std::clamp((point - a).dot(side) / side.squaredNorm(), 0.0, 1.0);
    return (point - a - share * side).norm();
}

/// A convex area in plan, corners counter-clockwise.
template <std::size_t corners>
struct ConvexArea {
    std::array<PlanCorner, corners> corner;

    [[nodiscard]] bool holds(const PlanCorner& point) const {
        for (std::size_t i = 0; i < corners; ++i) {
            if (turn_about(corner[i], corner[(i + 1) % corners], point) < 0.0) {
                return false;
            }
        }
        return true;
    }
    [[nodiscard]] double distance_m(const PlanCorner& point) const {
        if (holds(point)) {
            return 0.0;
        }
        double least_m = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < corners; ++i) {
            least_m = std::min(least_m, distance_to_side_m(point, corner[i], corner[(i + 1) % corners]));
        }
        return least_m;
    }
    [[nodiscard]] PlanCorner low_m() const {
        PlanCorner low = corner[0];
        for (const PlanCorner& each : corner) {
            low = low.cwiseMin(each);
        }
        return low;
    }
    [[nodiscard]] PlanCorner high_m() const {
        PlanCorner high = corner[0];
        for (const PlanCorner& each : corner) {
            high = high.cwiseMax(each);
        }
        return high;
    }
};

using PlanTriangle = ConvexArea<3>;
/// Between two cross-sections, feet to feet.
using Strip = ConvexArea<4>;

/// Whether two convex areas are farther apart than a margin: one of their sides separates them by it.
template <class One, class Other>
bool is_beyond_a_side(const One& one, const Other& other, double margin_m) {
    const std::size_t corners = one.corner.size();
    for (std::size_t i = 0; i < corners; ++i) {
        const PlanCorner& a = one.corner[i];
        const PlanCorner& b = one.corner[(i + 1) % corners];
        const double length_m = (b - a).norm();
        if (std::all_of(other.corner.begin(), other.corner.end(), [&](const PlanCorner& point) {
                return turn_about(a, b, point) < -margin_m * length_m;
            })) {
            return true;
        }
    }
    return false;
}

/// What an embankment covers in plan.
class Covered {
public:
    explicit Covered(const std::vector<CrossSection>& sections) {
        for (std::size_t i = 0; i + 1 < sections.size(); ++i) {
            strips_.push_back({{sections[i][3].head<2>(), sections[i + 1][3].head<2>(),
                                sections[i + 1][0].head<2>(), sections[i][0].head<2>()}});
            low_m_ = low_m_.cwiseMin(strips_.back().low_m());
            high_m_ = high_m_.cwiseMax(strips_.back().high_m());
        }
    }
    /// Whether a triangle reaches within a margin of it; a little farther ones may, too.
    [[nodiscard]] bool is_near(const PlanTriangle& triangle, double margin_m) const {
        const PlanCorner low = triangle.low_m().array() - margin_m;
        const PlanCorner high = triangle.high_m().array() + margin_m;
        const auto apart = [&](const PlanCorner& other_low, const PlanCorner& other_high) {
            return (low.array() > other_high.array()).any() || (high.array() < other_low.array()).any();
        };
        if (apart(low_m_, high_m_)) {
            return false;
        }
        return std::any_of(strips_.begin(), strips_.end(), [&](const Strip& strip) {
            return !apart(strip.low_m(), strip.high_m()) && !is_beyond_a_side(strip, triangle, margin_m) &&
                   !is_beyond_a_side(triangle, strip, margin_m);
        });
    }
    [[nodiscard]] double distance_m(const PlanCorner& point) const {
        double least_m = std::numeric_limits<double>::infinity();
        for (const Strip& strip : strips_) {
            least_m = std::min(least_m, strip.distance_m(point));
        }
        return least_m;
    }

private:
    std::vector<Strip> strips_;
    PlanCorner low_m_ = PlanCorner::Constant(std::numeric_limits<double>::infinity());
    PlanCorner high_m_ = PlanCorner::Constant(-std::numeric_limits<double>::infinity());
};

PlanCorner plan_corner_of(const Vertex& vertex) {
    return {vertex.x_m, vertex.y_m};
}

PlanTriangle plan_triangle_of(const Terrain& terrain, const Triangle& triangle) {
    return {{plan_corner_of(terrain.vertices()[triangle.corners[0]]),
             plan_corner_of(terrain.vertices()[triangle.corners[1]]),
             plan_corner_of(terrain.vertices()[triangle.corners[2]])}};
}

/// Points and edges to be meshed, and which vertex each point is; new ones follow those of the terrain.
struct PatchPoints {
    std::vector<Eigen::Vector3d> points_m;
    std::vector<std::uint32_t> vertex_of;
    std::vector<PointPair> lines;
};

/// The border of the triangles that are replaced, and the vertices among them that stay.
PatchPoints border_of(const Terrain& terrain, const std::vector<bool>& is_replaced, const Covered& covered) {
    PatchPoints patch;
    std::unordered_map<std::uint32_t, std::uint32_t> point_of;
    const auto point = [&](std::uint32_t vertex) {
        const auto [entry, is_new] =
            point_of.emplace(vertex, static_cast<std::uint32_t>(patch.points_m.size()));
        if (is_new) {
            const Vertex& v = terrain.vertices()[vertex];
            patch.points_m.emplace_back(v.x_m, v.y_m, v.z_m);
            patch.vertex_of.push_back(vertex);
        }
        return entry->second;
    };
    const auto for_each_replaced = [&](const auto& take) {
        for (std::uint32_t t = 0; t < is_replaced.size(); ++t) {
            if (is_replaced[t]) {
                take(terrain.triangles()[t]);
            }
        }
    };
    for_each_replaced([&](const Triangle& triangle) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t neighbour = triangle.neighbours[i];
            if (neighbour == no_triangle || !is_replaced[neighbour]) {
                const std::uint32_t from = point(triangle.corners[i]);
                const std::uint32_t to = point(triangle.corners[(i + 1) % 3]);
                patch.lines.push_back({from, to});
            }
        }
    });
    for_each_replaced([&](const Triangle& triangle) {
        for (const std::uint32_t corner : triangle.corners) {
            if (!point_of.contains(corner) &&
                covered.distance_m(plan_corner_of(terrain.vertices()[corner])) > 0.5 * embankment_margin_m) {
                point(corner);
            }
        }
    });
    return patch;
}

void add_sections(const std::vector<CrossSection>& sections, std::size_t first_new, PatchPoints& patch) {
    const auto first = static_cast<std::uint32_t>(patch.points_m.size());
    constexpr std::uint32_t across = 4;
    for (std::uint32_t s = 0; s < sections.size(); ++s) {
        for (std::uint32_t i = 0; i < across; ++i) {
            const std::uint32_t here = first + across * s + i;
            patch.points_m.push_back(sections[s][i]);
            patch.vertex_of.push_back(static_cast<std::uint32_t>(first_new + across * s + i));
            if (i + 1 < across) {
                patch.lines.push_back({here, here + 1});
            }
            if (s > 0) {
                patch.lines.push_back({here - across, here});
            }
        }
    }
}

/// Finds points again in a mesh of them, whose coordinates may have lost their last bits.
class PointFinder {
public:
    explicit PointFinder(const std::vector<Eigen::Vector3d>& points_m) : points_m_{points_m} {
        for (std::uint32_t p = 0; p < points_m.size(); ++p) {
            at_[cell_of(points_m[p].x(), points_m[p].y())].push_back(p);
        }
    }
    [[nodiscard]] std::uint32_t nearest(double x_m, double y_m) const {
        std::uint32_t found = no_triangle;
        double least2 = std::numeric_limits<double>::infinity();
        const auto [column, row] = cell_of(x_m, y_m);
        for (long long c = column - 1; c <= column + 1; ++c) {
            for (long long r = row - 1; r <= row + 1; ++r) {
                const auto here = at_.find({c, r});
                if (here == at_.end()) {
                    continue;
                }
                for (const std::uint32_t p : here->second) {
                    const double away2 = (points_m_[p].head<2>() - Eigen::Vector2d{x_m, y_m}).squaredNorm();
                    if (away2 < least2) {
                        least2 = away2;
                        found = p;
                    }
                }
            }
        }
        assert(found != no_triangle);
        return found;
    }

private:
    using PlanCell = std::pair<long long, long long>;
    static PlanCell cell_of(double x_m, double y_m) {
        constexpr double cells_per_m = 1e3;
        return {std::llround(std::floor(x_m * cells_per_m)), std::llround(std::floor(y_m * cells_per_m))};
    }
    const std::vector<Eigen::Vector3d>& points_m_;
    std::map<PlanCell, std::vector<std::uint32_t>> at_;
};

/// Joins triangles across their common edges, those whose neighbour is not known yet.
void join_neighbours(std::vector<Triangle>& triangles, const std::vector<std::uint32_t>& open) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<std::uint32_t, std::size_t>> edges;
    for (const std::uint32_t t : open) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (triangles[t].neighbours[i] != no_triangle) {
                continue;
            }
            const std::uint32_t from = triangles[t].corners[i];
            const std::uint32_t to = triangles[t].corners[(i + 1) % 3];
            if (const auto other = edges.find({to, from}); other != edges.end()) {
                triangles[t].neighbours[i] = other->second.first;
                triangles[other->second.first].neighbours[other->second.second] = t;
            } else {
                edges[{from, to}] = {t, i};
            }
        }
    }
}

}  // namespace

Terrain with_embankment(const Terrain& terrain, const PlacedEmbankment& placed, std::uint32_t surface) {
    const Covered covered{placed.sections};
    const std::span<const Triangle> before = terrain.triangles();
    std::vector<bool> is_replaced(before.size());
    std::vector<std::uint32_t> kept_as(before.size(), no_triangle);
    std::vector<Triangle> triangles;
    for (std::uint32_t t = 0; t < before.size(); ++t) {
        is_replaced[t] = covered.is_near(plan_triangle_of(terrain, before[t]), embankment_margin_m);
        if (!is_replaced[t]) {
            kept_as[t] = static_cast<std::uint32_t>(triangles.size());
            triangles.push_back(before[t]);
        }
    }
    std::vector<std::uint32_t> open;  // triangles with an edge whose neighbour is to be found
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        bool has_lost = false;
        for (std::uint32_t& neighbour : triangles[t].neighbours) {
            has_lost = has_lost || (neighbour != no_triangle && is_replaced[neighbour]);
            neighbour = neighbour == no_triangle ? no_triangle : kept_as[neighbour];
        }
        if (has_lost) {
            open.push_back(t);
        }
    }
    PatchPoints patch = border_of(terrain, is_replaced, covered);
    std::vector<Vertex> vertices{terrain.vertices().begin(), terrain.vertices().end()};
    add_sections(placed.sections, vertices.size(), patch);
    for (const CrossSection& section : placed.sections) {
        for (const Eigen::Vector3d& corner : section) {
            vertices.push_back({corner.x(), corner.y(), corner.z()});
        }
    }
    const Terrain mesh = triangulate(patch.points_m, patch.lines, 0.0);
    const PointFinder finder{patch.points_m};
    for (const Triangle& triangle : mesh.triangles()) {
        Triangle fresh{};
        PlanCorner middle = PlanCorner::Zero();
        for (std::size_t i = 0; i < 3; ++i) {
            const Vertex& vertex = mesh.vertices()[triangle.corners[i]];
            fresh.corners[i] = patch.vertex_of[finder.nearest(vertex.x_m + mesh.origin_m().x(),
                                                              vertex.y_m + mesh.origin_m().y())];
            fresh.neighbours[i] = no_triangle;
            middle += plan_corner_of(vertices[fresh.corners[i]]) / 3.0;
        }
        const auto below = terrain.locate(middle.x(), middle.y());
        if (!below || !is_replaced[*below]) {
            continue;  // a bay of the border
        }
        const bool is_covered = surface > 0 && covered.distance_m(middle) == 0.0;
        fresh.surface = is_covered ? surface : before[*below].surface;
        open.push_back(static_cast<std::uint32_t>(triangles.size()));
        triangles.push_back(fresh);
    }
    join_neighbours(triangles, open);
    return along_hilbert_curve(terrain.origin_m(), vertices, triangles);
}

}  // namespace rockfall
