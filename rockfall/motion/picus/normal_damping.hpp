#pragma once

#include "rockfall/laws/restitution.hpp"

namespace rockfall::picus {

/// Restitution at the given speed into the ground: the normal coefficient is r_n / (1 + (v_n / v_half)^2).
///
/// Pfeiffer & Bowen (1989), scaling factor of the Colorado Rockfall Simulation Program: a fast impact breaks
/// ground and rock where a slow one bounces. The whole speed, by which Johnson's law goes, says too little
/// where rocks fall onto a platform: they are slow along the ground and fast into it.
inline Restitution at_normal_speed(Restitution restitution, double into_ground_mps, double halved_mps) {
    if (halved_mps <= 0.0) {
        return restitution;
    }
    const double ratio = into_ground_mps / halved_mps;
    return {restitution.normal / (1.0 + ratio * ratio), restitution.tangential};
}

}  // namespace rockfall::picus
