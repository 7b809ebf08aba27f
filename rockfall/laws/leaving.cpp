#include "rockfall/laws/leaving.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rockfall {
namespace {

constexpr double never_leaves = std::numeric_limits<double>::infinity();

/// First time at which c0 + c1 t + c2 t^2 falls through zero; a start at or below zero counts as zero.
double time_of_leaving(double c0, double c1, double c2) {
    c0 = std::max(c0, 0.0);
    if (c0 == 0.0 && c1 < 0.0) {
        return 0.0;
    }
    const double discriminant = c1 * c1 - 4.0 * c2 * c0;
    if (discriminant < 0.0) {
        return never_leaves;
    }
    const double root = std::sqrt(discriminant);
    if (c1 < 0.0) {
        return 2.0 * c0 / (root - c1);  // falling from the start: the nearer root
    }
    return c2 < 0.0 ? (-c1 - root) / (2.0 * c2)
                    : never_leaves;  // rises first, comes back only if it bends down
}

/// When a piece leaves its triangle over one of those edges that `may_leave(c0, c1, c2)`: its distance from
/// the edge is c0 + c1 t + c2 t^2, by the length of the edge.
template <class MayLeave>
inline Leaving first_leaving(const Terrain& terrain, std::uint32_t triangle, const RollingPiece& piece,
                             const MayLeave& may_leave) {
    const Triangle& t = terrain.triangles()[triangle];
    Leaving first{never_leaves, 0};
    for (int i = 0; i < 3; ++i) {
        const Vertex& a = terrain.vertices()[t.corners[i]];
        const Vertex& b = terrain.vertices()[t.corners[i == 2 ? 0 : i + 1]];
        // Inward normal of a counter-clockwise edge, not normalised: only signs and times matter.
        const double nx = a.y_m - b.y_m;
        const double ny = b.x_m - a.x_m;
        const double c0 = nx * (piece.start_m.x() - a.x_m) + ny * (piece.start_m.y() - a.y_m);
        const double c1 = nx * piece.velocity_mps.x() + ny * piece.velocity_mps.y();
        const double c2 = 0.5 * (nx * piece.acceleration_mps2.x() + ny * piece.acceleration_mps2.y());
        if (may_leave(c0, c1, c2)) {
            const double time_s = time_of_leaving(c0, c1, c2);
            if (time_s < first.time_s) {
                first = {time_s, i};
            }
        }
    }
    return first;
}

/// Whether a neighbour goes on steeply up or down where a piece runs over to it.
bool is_cliff_or_wall(const Terrain& terrain, const Plane& here, std::uint32_t neighbour) {
    return neighbour != no_triangle &&
           (terrain.plane_of(neighbour).gradient - here.gradient).norm() > largest_overrun_tangent;
}

}  // namespace

Leaving leaving(const Terrain& terrain, std::uint32_t triangle, const RollingPiece& piece) {
    return first_leaving(terrain, triangle, piece, [](double, double, double) { return true; });
}

Leaving leaving_in_time(const Terrain& terrain, std::uint32_t triangle, const RollingPiece& piece) {
    const double until_s = piece.duration_s;
    return first_leaving(terrain, triangle, piece, [until_s](double c0, double c1, double c2) {
        // Most pieces are short and far from most edges: what they cannot reach needs no root. A part of the
        // distance covers what the root rounds away.
        constexpr double spare = 1e-6;
        return !(c0 + until_s * (std::min(c1, 0.0) + until_s * std::min(c2, 0.0)) > spare * c0);
    });
}

void end_at_edge(RollingPiece& piece, const Terrain& terrain, std::uint32_t triangle, const Leaving& out) {
    if (out.time_s <= piece.duration_s) {
        piece.duration_s = out.time_s;
        piece.end = RollingEnd::edge;
        piece.next_triangle = terrain.triangles()[triangle].neighbours[out.edge];
    }
}

void end_near_edge(RollingPiece& piece, const Terrain& terrain, std::uint32_t triangle, const Plane& plane,
                   const Leaving& out) {
    const double longest_s = piece.duration_s;
    end_at_edge(piece, terrain, triangle, out);
    if (piece.end == RollingEnd::edge && out.time_s < shortest_rolling_piece_s && out.time_s < longest_s &&
        !is_cliff_or_wall(terrain, plane, piece.next_triangle)) {
        piece.duration_s = std::min(longest_s, shortest_rolling_piece_s);
        piece.ran_over = true;
    }
}

std::uint32_t triangle_beyond(const Terrain& terrain, const RollingPiece& piece) {
    if (piece.next_triangle == no_triangle || !piece.ran_over) {
        return piece.next_triangle;
    }
    const Eigen::Vector3d end_m = piece.position_m(piece.duration_s);
    return terrain.locate(end_m.x(), end_m.y(), piece.next_triangle).value_or(no_triangle);
}

RollingPiece centimetre_on(const RollingPiece& run) {
    constexpr double way_m = 0.01;
    const Eigen::Vector3d velocity_mps = run.velocity_at(run.duration_s);
    return {run.position_m(run.duration_s),
            velocity_mps,
            Eigen::Vector3d::Zero(),
            way_m / velocity_mps.norm(),
            RollingEnd::piece,
            run.next_triangle,
            false,
            run.slides};
}

}  // namespace rockfall
