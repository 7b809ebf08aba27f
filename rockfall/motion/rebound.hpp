#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "config/math/elementary.hpp"
#include "config/units/angle.hpp"
#include "rockfall/motion/restitution.hpp"

namespace rockfall {

/// How a rock leaves the ground: by the jump-angle law or mirrored by the coefficients alone.
enum class ReboundAngle { jump_angle_law, geometric };

/// The part of a ground impact that turns the path sideways.
///
/// The paper's own law (Woltjer et al. 2008) is not public. These half ranges spread rocks over about 14 % of
/// the slope length, as the field reports (10-20 %: Azzoni & de Freitas 1995). Choice.
struct LateralDeviation {
    config::Angle at_rest = config::Angle::from_degrees(16.0);  ///< largest deviation of a slow rock
    config::Angle when_fast =
        config::Angle::from_degrees(11.0);  ///< largest deviation at and above `fast_mps`
    double fast_mps = 10.0;
};

/// Largest deviation at an impact speed: falls linearly with speed, then stays.
inline config::Angle largest_deviation(double speed_mps, const LateralDeviation& law) {
    const double share = std::min(speed_mps / law.fast_mps, 1.0);
    return config::Angle::from_radians(law.at_rest.in_radians() +
                                       share * (law.when_fast.in_radians() - law.at_rest.in_radians()));
}

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

/// Turns a direction in the plane about the plane's normal.
inline Eigen::Vector3d turned(const Eigen::Vector3d& direction, const Eigen::Vector3d& normal,
                              config::Angle angle) {
    const config::SinCos turn = config::sin_cos_of(angle.in_radians());
    const Eigen::Vector3d left{normal.y() * direction.z() - normal.z() * direction.y(),
                               normal.z() * direction.x() - normal.x() * direction.z(),
                               normal.x() * direction.y() - normal.y() * direction.x()};
    return turn.cos * direction + turn.sin * left;
}

/// Velocity after a rebound at `angle` above the plane along `direction`.
inline Eigen::Vector3d rebound(double speed_mps, config::Angle angle, const Eigen::Vector3d& direction,
                               const Eigen::Vector3d& normal) {
    const config::SinCos up = config::sin_cos_of(angle.in_radians());
    return speed_mps * (up.cos * direction + up.sin * normal);
}

/// Share of the geometric rebound in the rebound direction, by the impact's angle to the plane [-].
///
/// The jump-angle law was fitted to grazing impacts. Between 60 and 85 degrees (a cliff foot) the direction
/// goes over to the one that the two coefficients alone give. Choice; no published law.
inline double steepness_share(const Impact& impact) {
    constexpr double sin_60_deg = 0.86602540378443865;
    constexpr double sin_85_deg = 0.99619469809174555;
    const double speed_mps = std::sqrt(impact.into_ground_mps * impact.into_ground_mps +
                                       impact.along_slope_mps * impact.along_slope_mps);
    const double sine = speed_mps > 0.0 ? impact.into_ground_mps / speed_mps : 0.0;
    return std::clamp((sine - sin_60_deg) / (sin_85_deg - sin_60_deg), 0.0, 1.0);
}

/// Unit direction (along plane, normal) of a rebound, blended by `steep_share` from the angle of the law to
/// the geometric one.
inline Eigen::Vector2d blended_direction(config::Angle law_angle, const Impact& impact,
                                         Restitution restitution, double steep_share) {
    const config::SinCos law = config::sin_cos_of(law_angle.in_radians());
    const double out_mps = restitution.normal * impact.into_ground_mps;
    const double along_mps = restitution.tangential * impact.along_slope_mps;
    const double speed_mps = std::sqrt(out_mps * out_mps + along_mps * along_mps);
    if (speed_mps <= 0.0) {
        return {law.cos, law.sin};
    }
    const Eigen::Vector2d blend{(1.0 - steep_share) * law.cos + steep_share * along_mps / speed_mps,
                                (1.0 - steep_share) * law.sin + steep_share * out_mps / speed_mps};
    return blend / std::sqrt(blend.x() * blend.x() + blend.y() * blend.y());
}

}  // namespace rockfall
