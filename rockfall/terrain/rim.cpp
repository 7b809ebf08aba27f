#include "rockfall/terrain/rim.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "rockfall/terrain/plan.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace rockfall {
namespace {

/// Rings of triangles around the last one below a rock that are searched for the rim. A rock leaves over an
/// edge of that triangle, or of one that touches it where the place is rounded; blocks move on by a step
/// before they are found outside, which is a few triangles of a fine mesh [choice].
constexpr int rings_searched = 4;

/// Components of a unit normal closer than this point between two sides: an edge along a diagonal of cells.
constexpr double between_sides = 1e-6;

double away_from_edge_m(const Eigen::Vector2d& place_m, const Eigen::Vector2d& from_m,
                        const Eigen::Vector2d& to_m) {
    const Eigen::Vector2d along_m = to_m - from_m;
    const double share = std::clamp((place_m - from_m).dot(along_m) / along_m.squaredNorm(), 0.0, 1.0);
    return (place_m - from_m - share * along_m).norm();
}

/// The side to which an outward direction points.
RimPart side_of(const Eigen::Vector2d& outward, const Eigen::Vector2d& way) {
    const double lead = std::abs(outward.x()) - std::abs(outward.y());
    const bool east_west =
        std::abs(lead) > between_sides * outward.norm() ? lead > 0.0 : std::abs(way.x()) > std::abs(way.y());
    if (east_west) {
        return outward.x() > 0.0 ? RimPart::east : RimPart::west;
    }
    return outward.y() > 0.0 ? RimPart::north : RimPart::south;
}

/// Area and first moments of a loop about a point of it.
struct LoopSums {
    double area2_m2 = 0.0;  ///< twice the area, positive counter-clockwise
    Eigen::Vector2d moment_m3 = Eigen::Vector2d::Zero();

    void add(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        const double twice = cross_in_plan(a, b);
        area2_m2 += twice;
        moment_m3 += twice * (a + b) / 3.0;
    }
};

}  // namespace

Rim::Rim(const Terrain& terrain) {
    const auto triangles = terrain.triangles();
    const auto vertices = terrain.vertices();
    for (std::uint32_t triangle = 0; triangle < triangles.size(); ++triangle) {
        const Triangle& t = triangles[triangle];
        for (std::uint32_t i = 0; i < 3; ++i) {
            if (t.neighbours[i] == no_triangle) {
                const Vertex& a = vertices[t.corners[i]];
                const Vertex& b = vertices[t.corners[(i + 1) % 3]];
                edges_.push_back({std::uint64_t{3} * triangle + i, {a.x_m, a.y_m}, {b.x_m, b.y_m}, no_hole});
            }
        }
    }
    close_loops(terrain);
}

std::size_t Rim::place_of(std::uint64_t key) const {
    const auto found =
        std::lower_bound(edges_.begin(), edges_.end(), key,
                         [](const Edge& edge, std::uint64_t wanted) { return edge.key < wanted; });
    return static_cast<std::size_t>(found - edges_.begin());
}

/// The rim goes on at the end of an edge with the next edge that has no neighbour, found by turning around
/// that corner through the triangles that meet there.
void Rim::close_loops(const Terrain& terrain) {
    const auto triangles = terrain.triangles();
    const auto next_of = [&](std::uint64_t key) {
        auto triangle = static_cast<std::uint32_t>(key / 3);
        std::uint32_t edge = (static_cast<std::uint32_t>(key % 3) + 1) % 3;
        for (std::size_t turned = 0; turned <= triangles.size(); ++turned) {
            const std::uint32_t beyond = triangles[triangle].neighbours[edge];
            if (beyond == no_triangle) {
                break;
            }
            const auto& neighbours = triangles[beyond].neighbours;
            const auto* shared = std::find(std::begin(neighbours), std::end(neighbours), triangle);
            if (shared == std::end(neighbours)) {
                break;  // not a neighbour the other way round: no mesh of ours
            }
            edge = (static_cast<std::uint32_t>(shared - std::begin(neighbours)) + 1) % 3;
            triangle = beyond;
        }
        return std::uint64_t{3} * triangle + edge;
    };
    std::vector<std::uint8_t> seen(edges_.size(), 0);
    std::vector<std::size_t> loop;
    for (std::size_t first = 0; first < edges_.size(); ++first) {
        if (seen[first] != 0) {
            continue;
        }
        loop.clear();
        LoopSums sums;
        const Eigen::Vector2d about_m = edges_[first].from_m;
        for (std::size_t here = first; here < edges_.size() && seen[here] == 0;
             here = place_of(next_of(edges_[here].key))) {
            seen[here] = 1;
            loop.push_back(here);
            sums.add(edges_[here].from_m - about_m, edges_[here].to_m - about_m);
        }
        if (sums.area2_m2 < 0.0) {
            for (const std::size_t edge : loop) {
                edges_[edge].hole = static_cast<std::uint32_t>(holes_.size());
            }
            holes_.push_back({about_m + sums.moment_m3 / sums.area2_m2, -0.5 * sums.area2_m2});
        }
    }
}

/// Ring by ring; none if the rim is further away.
const Rim::Edge* Rim::nearest_around(const Terrain& terrain, std::uint32_t triangle,
                                     const Eigen::Vector2d& place_m) const {
    const auto triangles = terrain.triangles();
    if (triangle >= triangles.size()) {
        return nullptr;
    }
    std::vector<std::uint32_t> visited{triangle};
    std::size_t ring_begin = 0;
    for (int ring = 0; ring < rings_searched; ++ring) {
        const Edge* nearest = nullptr;
        double least_m = std::numeric_limits<double>::infinity();
        const std::size_t ring_end = visited.size();
        for (std::size_t at = ring_begin; at < ring_end; ++at) {
            const auto& neighbours = triangles[visited[at]].neighbours;
            for (std::uint32_t i = 0; i < 3; ++i) {
                if (neighbours[i] == no_triangle) {
                    const Edge& edge = edges_[place_of(std::uint64_t{3} * visited[at] + i)];
                    const double away_m = away_from_edge_m(place_m, edge.from_m, edge.to_m);
                    if (away_m < least_m) {
                        least_m = away_m;
                        nearest = &edge;
                    }
                } else if (std::find(visited.begin(), visited.end(), neighbours[i]) == visited.end()) {
                    visited.push_back(neighbours[i]);
                }
            }
        }
        if (nearest != nullptr) {
            return nearest;
        }
        ring_begin = ring_end;
    }
    return nullptr;
}

const Rim::Edge* Rim::nearest_of_all(const Eigen::Vector2d& place_m) const {
    const Edge* nearest = nullptr;
    double least_m = std::numeric_limits<double>::infinity();
    for (const Edge& edge : edges_) {
        const double away_m = away_from_edge_m(place_m, edge.from_m, edge.to_m);
        if (away_m < least_m) {
            least_m = away_m;
            nearest = &edge;
        }
    }
    return nearest;
}

RimPart Rim::part_at(const Terrain& terrain, std::uint32_t triangle, const Eigen::Vector2d& end_m,
                     const Eigen::Vector2d& from_m) const {
    const Eigen::Vector2d way_m = end_m - from_m;
    const Edge* edge = nearest_around(terrain, triangle, end_m);
    if (edge == nullptr) {
        edge = nearest_of_all(end_m);
    }
    if (edge == nullptr) {
        return side_of(way_m, way_m);
    }
    if (edge->hole != no_hole) {
        return hole_part(edge->hole);
    }
    // Triangles run counter-clockwise: outside lies to the right.
    const Eigen::Vector2d along_m = edge->to_m - edge->from_m;
    return side_of({along_m.y(), -along_m.x()}, way_m);
}

}  // namespace rockfall
