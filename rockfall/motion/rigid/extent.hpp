#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "rockfall/motion/rigid/body.hpp"

namespace rockfall::rigid {

/// How far a block reaches from its centre in a direction (unit) [m].
inline double reach_m(const solids::Solid& solid, const Body& body, const Eigen::Vector3d& direction) {
    if (solid.is_sphere()) {
        return solid.bounding_radius_m;
    }
    const Eigen::Vector3d local = body.rotation.attitude.conjugate() * direction;
    double farthest_m = 0.0;
    for (const Eigen::Vector3d& vertex_m : solid.hull.vertices_m) {
        farthest_m = std::max(farthest_m, local.dot(vertex_m));
    }
    return farthest_m;
}

/// Distance in plan of a vertical line from the block's shadow; 0 inside [m].
double plan_distance_m(const solids::Solid& solid, const Body& body, const Eigen::Vector2d& line_m);

/// Distance of a straight piece from the block; 0 where they meet [m].
double distance_from_piece_m(const solids::Solid& solid, const Body& body, const Eigen::Vector3d& from_m,
                             const Eigen::Vector3d& to_m);

}  // namespace rockfall::rigid
