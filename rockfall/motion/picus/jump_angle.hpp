#pragma once

#include <algorithm>
#include <numbers>

#include "config/math/elementary.hpp"
#include "config/units/angle.hpp"

namespace rockfall::picus {

/// The angle between slope and path just after a rebound falls with the speed after it.
///
/// alpha = coefficient * v^-exponent, fitted on 63 rebounds of the unforested site at Vaujany
/// (Rammer et al. 2010, Eq. 9). The fit exceeds 90 degrees below 0.85 m/s, hence the cap.
struct JumpAngleLaw {
    config::Angle coefficient = config::Angle::from_degrees(64.0);  ///< at 1 m/s; the published fit: 80
    double exponent = 0.74;                                         ///< [-]
    config::Angle cap = config::Angle::from_degrees(60.0);
    double scatter = 0.5;  ///< standard deviation of ln(alpha) [-]; 0 gives the fitted curve
};

/// Jump angle at a squared speed; `normal_draw` is a standard normal deviate that scatters it, `factor` that
/// of the ground type. The cap comes last.
inline config::Angle jump_angle(double squared_speed_m2ps2, const JumpAngleLaw& law, double normal_draw = 0.0,
                                double factor = 1.0) {
    // One exponential serves power law and scatter: v^-b * exp(s z) = 2^(-b/2 log2 v^2 + s z log2 e).
    const double exponent = -0.5 * law.exponent * config::log2_of(std::max(squared_speed_m2ps2, 1e-12)) +
                            std::numbers::log2e * law.scatter * normal_draw;
    const double angle_rad = factor * law.coefficient.in_radians() * config::exp2_of(exponent);
    return config::Angle::from_radians(std::min(angle_rad, law.cap.in_radians()));
}

}  // namespace rockfall::picus
