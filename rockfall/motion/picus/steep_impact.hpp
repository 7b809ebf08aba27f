#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "config/math/elementary.hpp"
#include "config/units/angle.hpp"
#include "rockfall/laws/rebound.hpp"

namespace rockfall::picus {

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

}  // namespace rockfall::picus
