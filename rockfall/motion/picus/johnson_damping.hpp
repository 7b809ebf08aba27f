#pragma once

#include <cmath>

#include "rockfall/laws/restitution.hpp"

namespace rockfall::picus {

/// Published restitution coefficients come from drops of about this speed.
inline constexpr double restitution_reference_speed_mps = 10.0;

/// Restitution at the given impact speed.
///
/// Published values hold up to the reference speed. Above it both components fall with the fourth root of
/// speed, as ground yields plastically (Johnson 1985; Rammer et al. 2010, Eqs. 7-8). Takes the squared speed,
/// which the caller has: (v0/v)^(1/4) = ((v0^2/v^2)^(1/2))^(1/4).
inline Restitution at_impact_speed(Restitution published, double squared_speed_m2ps2) {
    constexpr double reference2 = restitution_reference_speed_mps * restitution_reference_speed_mps;
    if (squared_speed_m2ps2 <= reference2) {
        return published;
    }
    const double factor = std::sqrt(std::sqrt(std::sqrt(reference2 / squared_speed_m2ps2)));
    return {published.normal * factor, published.tangential * factor};
}

}  // namespace rockfall::picus
