#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "config/math/elementary.hpp"
#include "config/units/angle.hpp"

namespace rockfall {

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

/// Turns a direction in the plane about the plane's normal.
inline Eigen::Vector3d turned(const Eigen::Vector3d& direction, const Eigen::Vector3d& normal,
                              config::Angle angle) {
    const config::SinCos turn = config::sin_cos_of(angle.in_radians());
    const Eigen::Vector3d left{normal.y() * direction.z() - normal.z() * direction.y(),
                               normal.z() * direction.x() - normal.x() * direction.z(),
                               normal.x() * direction.y() - normal.y() * direction.x()};
    return turn.cos * direction + turn.sin * left;
}

}  // namespace rockfall
