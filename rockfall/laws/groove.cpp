#include "rockfall/laws/groove.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "config/units/constants.hpp"

namespace rockfall {
namespace {

/// A slower rock stands: it has no direction of its own.
constexpr double standing_in_groove_mps = 1e-3;

/// How strongly gravity drives a rock on a face across an edge of it.
double across_edge_mps2(const Eigen::Vector3d& normal, const Eigen::Vector3d& edge) {
    const Eigen::Vector3d along_face =
        config::gravity_mps2 * (normal.z() * normal - Eigen::Vector3d::UnitZ());
    return (along_face - along_face.dot(edge) * edge).norm();
}

/// The share of its weight with which a rock that goes to and fro over an edge rests on the two faces by
/// turns: the shares of the faces, each for as long as the rock is on it, which is the longer the less it is
/// driven back.
double mean_support(const Plane& here, const Plane& there, const Eigen::Vector3d& edge) {
    const Eigen::Vector3d n = here.normal();
    const Eigen::Vector3d m = there.normal();
    const double back = across_edge_mps2(n, edge);
    const double forth = across_edge_mps2(m, edge);
    return (n.z() * forth + m.z() * back) / (back + forth);
}

/// Where gravity leads on a face, in plan.
Eigen::Vector2d gravity_in_plan_mps2(const Plane& face) {
    return -config::gravity_mps2 / (1.0 + face.gradient.squaredNorm()) * face.gradient;
}

Eigen::Vector3d place_of(const Vertex& vertex) {
    return {vertex.x_m, vertex.y_m, vertex.z_m};
}

/// The place on an edge that is nearest to a point in plan.
Eigen::Vector3d foot_on_edge(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
                             const Eigen::Vector3d& b) {
    const Eigen::Vector2d edge = (b - a).head<2>();
    const Eigen::Vector2d to_point = (point - a).head<2>();
    const double share = std::min(1.0, std::max(0.0, to_point.dot(edge) / edge.squaredNorm()));
    return a + share * (b - a);
}

/// Whether the faces on both sides of an edge lie in one plane: no groove, whatever the mesh.
bool is_flat_across(const Terrain& terrain, std::uint32_t triangle, int side) {
    const std::uint32_t beyond = terrain.triangles()[triangle].neighbours[side];
    if (beyond == no_triangle) {
        return false;
    }
    constexpr double flat_m = 1e-9;
    const Plane plane = terrain.plane_of(triangle);
    const Vertex& own = terrain.vertices()[terrain.triangles()[triangle].corners[side]];
    const auto& corners = terrain.triangles()[beyond].corners;
    return std::all_of(std::begin(corners), std::end(corners), [&](std::uint32_t corner) {
        const Eigen::Vector3d from_plane = place_of(terrain.vertices()[corner]) - place_of(own);
        return std::abs(plane.normal().dot(from_plane)) < flat_m;
    });
}

/// The steepest way seen so far: towards a vertex.
struct Way {
    double fall_tangent = 0.0;
    Eigen::Vector3d end_m = Eigen::Vector3d::Zero();
    std::uint32_t triangle = no_triangle;
};

/// The way from a place near an edge to its end `to`, as steep as both the way and the edge from its point
/// `foot` on are: a rock on the wall of a crack gets no steeper way than the floor is. Ends nearer than
/// `reach_m` lead nowhere.
void consider(const Eigen::Vector3d& from, const Eigen::Vector3d& foot, const Eigen::Vector3d& to,
              double reach_m, std::uint32_t triangle, Way& best) {
    const auto fall_tangent = [&](const Eigen::Vector3d& begin) {
        return (begin.z() - to.z()) / (to - begin).head<2>().norm();
    };
    const bool leads_away = (to - from).head<2>().norm() > reach_m;
    const double tangent = leads_away ? std::min(fall_tangent(from), fall_tangent(foot)) : 0.0;
    if (tangent > best.fall_tangent) {
        best = {tangent, to, triangle};
    }
}

int corner_number(const Triangle& triangle, std::uint32_t vertex) {
    return triangle.corners[0] == vertex ? 0 : (triangle.corners[1] == vertex ? 1 : 2);
}

/// Looks along all edges that meet at a vertex, turning counter-clockwise and then the other way if a border
/// ends the turn. Returns whether it lies on the border.
bool consider_edges_at(const Terrain& terrain, std::uint32_t triangle, std::uint32_t vertex,
                       const Eigen::Vector3d& position_m, double reach_m, Way& best) {
    for (const int turn : {2, 0}) {  // across the edge that ends at the vertex, or the one that begins there
        std::uint32_t t = triangle;
        do {
            const Triangle& here = terrain.triangles()[t];
            const int k = corner_number(here, vertex);
            for (const int other : {(k + 1) % 3, (k + 2) % 3}) {
                consider(position_m, place_of(terrain.vertices()[vertex]),
                         place_of(terrain.vertices()[here.corners[other]]), reach_m, t, best);
            }
            t = here.neighbours[(k + turn) % 3];
        } while (t != no_triangle && t != triangle);
        if (t == triangle) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::optional<RollingPiece> run_along_groove(const Terrain& terrain, std::uint32_t triangle,
                                             const Eigen::Vector3d& position_m, double reach_m,
                                             const GrooveLaw& law) {
    const Triangle& t = terrain.triangles()[triangle];
    Way best;
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d a = place_of(terrain.vertices()[t.corners[i]]);
        const Eigen::Vector3d b = place_of(terrain.vertices()[t.corners[(i + 1) % 3]]);
        const Eigen::Vector3d foot = foot_on_edge(position_m, a, b);
        const bool is_near = (foot - position_m).head<2>().norm() < reach_m;
        for (const Eigen::Vector3d& end : {a, b}) {
            if (is_near && !is_flat_across(terrain, triangle, i)) {
                consider(position_m, foot, end, reach_m, triangle, best);
            }
        }
        if ((a - position_m).head<2>().norm() < reach_m &&
            consider_edges_at(terrain, triangle, t.corners[i], position_m, reach_m, best)) {
            consider(position_m, foot, a, 0.0, triangle, best);  // the terrain ends there, however near
        }
    }
    if (best.fall_tangent <= law.friction) {
        return std::nullopt;
    }
    const Eigen::Vector3d way = best.end_m - position_m;
    const double length_m = way.norm();
    const double cosine = 1.0 / std::sqrt(1.0 + best.fall_tangent * best.fall_tangent);
    const double acceleration =
        law.mass_factor * config::gravity_mps2 * cosine * (best.fall_tangent - law.friction);
    return RollingPiece{position_m,
                        Eigen::Vector3d::Zero(),
                        acceleration / length_m * way,
                        std::sqrt(2.0 * length_m / acceleration),
                        RollingEnd::edge,
                        best.triangle,
                        false,
                        law.slides};
}

std::optional<RollingPiece> run_if_pressed(const Terrain& terrain, std::uint32_t from, std::uint32_t triangle,
                                           const Eigen::Vector3d& position_m,
                                           const Eigen::Vector3d& velocity_mps, const GrooveLaw& law) {
    const Triangle& t = terrain.triangles()[triangle];
    const auto* const shared = std::find(std::begin(t.neighbours), std::end(t.neighbours), from);
    if (shared == std::end(t.neighbours)) {
        return std::nullopt;
    }
    const auto side = static_cast<std::size_t>(shared - std::begin(t.neighbours));
    const Eigen::Vector3d a = place_of(terrain.vertices()[t.corners[side]]);
    const Eigen::Vector3d b = place_of(terrain.vertices()[t.corners[side == 2 ? 0 : side + 1]]);
    const Eigen::Vector2d inward = Eigen::Vector2d{a.y() - b.y(), b.x() - a.x()}.normalized();
    const Plane here = terrain.plane_of(triangle);
    const Plane there = terrain.plane_of(from);
    const double back_mps2 = -law.mass_factor * inward.dot(gravity_in_plan_mps2(here));
    const double forth_mps2 = law.mass_factor * inward.dot(gravity_in_plan_mps2(there));
    const bool is_back_at_once =
        2.0 * inward.dot(velocity_mps.head<2>()) <= back_mps2 * shortest_rolling_piece_s;
    if (back_mps2 <= 0.0 || forth_mps2 <= 0.0 || !is_back_at_once) {
        return std::nullopt;
    }
    Eigen::Vector3d direction = (b - a).normalized();
    // What goes straight into the groove, as between the steep walls of a crack, is lost.
    double speed_mps = std::abs(direction.dot(velocity_mps));
    const bool stands = speed_mps < standing_in_groove_mps;
    if (stands ? direction.z() > 0.0 : direction.dot(velocity_mps) < 0.0) {
        direction = -direction;
    }
    const double acceleration = law.mass_factor * config::gravity_mps2 *
                                (-direction.z() - law.friction * mean_support(here, there, direction));
    const Eigen::Vector3d& end_m = direction.dot(b - a) > 0.0 ? b : a;
    const double length_m = std::max(0.0, direction.dot(end_m - position_m));
    RollingPiece run{position_m,
                     speed_mps * direction,
                     acceleration * direction,
                     0.0,
                     RollingEnd::standstill,
                     triangle,
                     false,
                     law.slides};
    if (stands) {
        run.velocity_mps.setZero();
        speed_mps = 0.0;
        if (acceleration <= 0.0) {
            run.acceleration_mps2.setZero();
            return run;
        }
    }
    const double squared_end = speed_mps * speed_mps + 2.0 * acceleration * length_m;
    if (squared_end <= 0.0) {
        run.duration_s = acceleration < 0.0 ? speed_mps / -acceleration : 0.0;
        return run.duration_s > 0.0 ? std::optional{run}
                                    : std::nullopt;  // at rest at the lower end: no way on
    }
    run.duration_s = 2.0 * length_m / (speed_mps + std::sqrt(squared_end));
    run.end = RollingEnd::edge;
    return run;
}

Eigen::Vector3d along_edge(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& normal,
                           const Eigen::Vector3d& next_normal) {
    const Eigen::Vector3d edge = normal.cross(next_normal);
    const double squared = edge.squaredNorm();
    constexpr double one_plane = 1e-18;  // an angle of 1e-9 between the faces
    if (squared < one_plane) {
        return velocity_mps - velocity_mps.dot(next_normal) * next_normal;
    }
    return velocity_mps.dot(edge) / squared * edge;
}

}  // namespace rockfall
