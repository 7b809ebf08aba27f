#pragma once

#include <cstdint>

#include "config/units/angle.hpp"
#include "rockfall/laws/losses.hpp"

namespace rockfall::classical {

/// Where the friction of sliding comes from.
enum class Friction : std::uint8_t {
    from_rt,  ///< of the ground type: (1 - r_t) / r_t
    angle,    ///< one angle for all
    ground,   ///< sliding friction of the ground type, else of its soil
};

/// The settings of the classical lumped-mass model with constant restitution; sources in parameters.cpp and
/// README.md.
struct Law {
    double restitution_deviation = 0.04;  ///< standard deviation of each coefficient [-]
    config::Angle lateral = config::Angle::from_degrees(11.0);  ///< largest turn of an impact, either way
    Friction friction = Friction::from_rt;
    double friction_angle_tangent = 0.57735026918962576;  ///< where `friction` is `angle` [-]
    double edge_angle_tangent = 0.069926811943510413;  ///< of the bend between faces that a rock follows [-]
    double position_tolerance_m = 1e-3;                ///< error of one step of sliding
    double least_hop = 0.1;  ///< hops shorter than this times the rock's radius are sliding [-]
    std::uint32_t most_impacts = 20'000;
    LossLaw losses{};
};

/// Settings that users write in another form than the law uses them: angles in degrees.
struct Written {
    double lateral_deg = 11.0;
    double friction_angle_deg = 30.0;
};

}  // namespace rockfall::classical
