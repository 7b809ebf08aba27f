#pragma once

#include <algorithm>
#include <cmath>

namespace rockfall {

/// Speed after a ground impact divided by the speed before it, by component [-].
struct Restitution {
    double normal = 0.0;
    double tangential = 0.0;
};

/// How the published coefficients are varied.
struct RestitutionLaw {
    bool damping = true;             ///< fall with impact speed above the reference speed
    double tangential_noise = 0.05;  ///< half width of the uniform noise on the tangential coefficient [-]
};

/// Published restitution coefficients come from drops of about this speed.
inline constexpr double restitution_reference_speed_mps = 10.0;

/// No noise may turn a contact into a source of energy.
inline constexpr double largest_restitution = 0.99;

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

/// The tangential coefficient with its noise: `draw` on [-1, 1) (Rammer et al. 2010, section 2.4.1).
inline Restitution with_noise(Restitution published, double half_width, double draw) {
    return {published.normal, std::clamp(published.tangential + half_width * draw, 0.0, largest_restitution)};
}

}  // namespace rockfall
