#pragma once

#include <cstdint>

#include "rockfall/laws/ground_deviation.hpp"
#include "rockfall/laws/losses.hpp"
#include "rockfall/laws/rebound.hpp"
#include "rockfall/laws/restitution.hpp"
#include "rockfall/laws/rolling.hpp"
#include "rockfall/laws/stopping.hpp"
#include "rockfall/motion/picus/facet.hpp"
#include "rockfall/motion/picus/jump_angle.hpp"

namespace rockfall::picus {

/// How often the noise on the tangential coefficient is drawn again.
enum class NoiseScope : std::uint8_t { off, impact, rock };

/// The ground contact of PICUS Rock'n'Roll (Rammer et al. 2010) with its settings.
struct Law {
    RestitutionLaw restitution;
    NoiseScope noise = NoiseScope::impact;
    ReboundAngle angle = ReboundAngle::jump_angle_law;
    JumpAngleLaw jump_angle;
    bool jump_angle_by_ground = true;  ///< times the factor of the ground type
    bool stops_by_hop_length =
        false;  ///< a hop counts for as many impacts as it is longer, see hop_share.hpp
    FacetLaw facets;
    bool impact_friction = true;  ///< impacts take at least what dry friction does, see impact_friction.hpp
    LossLaw losses;
    bool blend_steep_impacts = true;
    LateralDeviation lateral;
    RollingLaw rolling;
    StoppingLaw stopping;
};

/// Settings that users write in another form than the law uses them: angles in degrees.
struct Written {
    double jump_angle_coefficient_deg = 64.0;
    double jump_angle_cap_deg = 60.0;
    double lateral_slow_deg = 16.0;
    double lateral_fast_deg = 11.0;
};

}  // namespace rockfall::picus
