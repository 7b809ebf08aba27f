#include "rockfall/motion/groove.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "config/units/constants.hpp"

namespace rockfall {
namespace {

Eigen::Vector3d place_of(const Vertex& vertex) {
    return {vertex.x_m, vertex.y_m, vertex.z_m};
}

/// Plan distance from a point to an edge.
double distance_to_edge_m(const Eigen::Vector3d& point, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const Eigen::Vector2d edge = (b - a).head<2>();
    const Eigen::Vector2d to_point = (point - a).head<2>();
    const double share = std::min(1.0, std::max(0.0, to_point.dot(edge) / edge.squaredNorm()));
    return (to_point - share * edge).norm();
}

/// The steepest way seen so far: towards a vertex.
struct Way {
    double fall_tangent = 0.0;
    Eigen::Vector3d end_m = Eigen::Vector3d::Zero();
    std::uint32_t triangle = no_triangle;
};

/// Ends nearer than `reach_m` lead nowhere.
void consider(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double reach_m, std::uint32_t triangle,
              Way& best) {
    const double length_m = (to - from).head<2>().norm();
    const double tangent = length_m > reach_m ? (from.z() - to.z()) / length_m : 0.0;
    if (tangent > best.fall_tangent) {
        best = {tangent, to, triangle};
    }
}

int corner_number(const Triangle& triangle, std::uint32_t vertex) {
    return triangle.corners[0] == vertex ? 0 : (triangle.corners[1] == vertex ? 1 : 2);
}

/// Looks along all edges that meet at a vertex, turning counter-clockwise and then the other way if a border
/// ends the turn.
void consider_edges_at(const Terrain& terrain, std::uint32_t triangle, std::uint32_t vertex,
                       const Eigen::Vector3d& position_m, double reach_m, Way& best) {
    for (const int turn : {2, 0}) {  // across the edge that ends at the vertex, or the one that begins there
        std::uint32_t t = triangle;
        do {
            const Triangle& here = terrain.triangles()[t];
            const int k = corner_number(here, vertex);
            for (const int other : {(k + 1) % 3, (k + 2) % 3}) {
                consider(position_m, place_of(terrain.vertices()[here.corners[other]]), reach_m, t, best);
            }
            t = here.neighbours[(k + turn) % 3];
        } while (t != no_triangle && t != triangle);
        if (t == triangle) {
            return;
        }
    }
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
        if (distance_to_edge_m(position_m, a, b) < reach_m) {
            consider(position_m, a, reach_m, triangle, best);
            consider(position_m, b, reach_m, triangle, best);
        }
        if ((a - position_m).head<2>().norm() < reach_m) {
            consider_edges_at(terrain, triangle, t.corners[i], position_m, reach_m, best);
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
