#pragma once

#include <Eigen/Core>

#include "config/math/elementary.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace rockfall {

/// A velocity laid into the face with a normal: its direction is the shadow straight onto the face, its speed
/// is kept. One straight into the face has no direction left and stands.
inline Eigen::Vector3d laid_into(const Eigen::Vector3d& normal, const Eigen::Vector3d& velocity_mps) {
    const Eigen::Vector3d along = velocity_mps - velocity_mps.dot(normal) * normal;
    const double along_mps = along.norm();
    return along_mps > 0.0 ? Eigen::Vector3d{velocity_mps.norm() / along_mps * along}
                           : Eigen::Vector3d::Zero();
}

/// A velocity on a face after a turn in plan: heading and speed are kept, the rise follows the face.
inline Eigen::Vector3d rising_with(const Plane& face, const Eigen::Vector3d& velocity_mps) {
    const double speed_mps = velocity_mps.norm();
    const Eigen::Vector3d tilted_mps{
        velocity_mps.x(), velocity_mps.y(),
        face.gradient.x() * velocity_mps.x() + face.gradient.y() * velocity_mps.y()};
    const double tilted_speed_mps = tilted_mps.norm();
    return tilted_mps * (tilted_speed_mps > 0.0 ? speed_mps / tilted_speed_mps : 0.0);
}

/// A velocity turned in plan, counter-clockwise.
inline Eigen::Vector3d turned_in_plan(const Eigen::Vector3d& velocity_mps, const config::SinCos& turn) {
    return {turn.cos * velocity_mps.x() - turn.sin * velocity_mps.y(),
            turn.sin * velocity_mps.x() + turn.cos * velocity_mps.y(), velocity_mps.z()};
}

}  // namespace rockfall
