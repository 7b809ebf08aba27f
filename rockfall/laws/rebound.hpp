#pragma once

#include <Eigen/Core>
#include <cmath>

#include "config/math/elementary.hpp"
#include "config/units/angle.hpp"
#include "rockfall/laws/restitution.hpp"

namespace rockfall {

/// How a rock leaves the ground: by the jump-angle law or mirrored by the coefficients alone.
enum class ReboundAngle { jump_angle_law, geometric };

/// An incoming velocity split at a plane.
struct Impact {
    double into_ground_mps;     ///< speed into the ground, > 0
    double along_slope_mps;     ///< speed along the plane
    Eigen::Vector3d direction;  ///< unit vector of the motion along the plane
};

/// Splits a velocity at a plane. A rock that comes straight down leaves along the steepest descent.
inline Impact split(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& normal) {
    const double along_normal_mps = velocity_mps.dot(normal);
    const Eigen::Vector3d along_mps = velocity_mps - along_normal_mps * normal;
    const double along_slope_mps = along_mps.norm();
    constexpr double no_direction_mps = 1e-6;
    if (along_slope_mps > no_direction_mps) {
        return {-along_normal_mps, along_slope_mps, along_mps / along_slope_mps};
    }
    const Eigen::Vector3d downhill{normal.x() * normal.z(), normal.y() * normal.z(),
                                   -(normal.x() * normal.x() + normal.y() * normal.y())};
    const double steepness = downhill.norm();
    return {-along_normal_mps, along_slope_mps,
            steepness > 0.0 ? Eigen::Vector3d{downhill / steepness} : Eigen::Vector3d::UnitX()};
}

/// Speed after an impact: sqrt((r_n v_n)^2 + (r_t v_t)^2), below the speed before it.
inline double speed_after(const Impact& impact, Restitution restitution) {
    const double normal_mps = restitution.normal * impact.into_ground_mps;
    const double tangential_mps = restitution.tangential * impact.along_slope_mps;
    return std::sqrt(normal_mps * normal_mps + tangential_mps * tangential_mps);
}

/// Velocity after a rebound at `angle` above the plane along `direction`.
inline Eigen::Vector3d rebound(double speed_mps, config::Angle angle, const Eigen::Vector3d& direction,
                               const Eigen::Vector3d& normal) {
    const config::SinCos up = config::sin_cos_of(angle.in_radians());
    return speed_mps * (up.cos * direction + up.sin * normal);
}

}  // namespace rockfall
