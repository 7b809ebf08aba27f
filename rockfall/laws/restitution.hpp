#pragma once

#include <algorithm>

namespace rockfall {

/// Speed after a ground impact divided by the speed before it, by component [-].
struct Restitution {
    double normal = 0.0;
    double tangential = 0.0;
};

/// 30 ft/s, the constant of the Colorado Rockfall Simulation Program (Pfeiffer & Bowen 1989) [m/s].
inline constexpr double pfeiffer_bowen_mps = 30.0 * 0.3048;

/// How the coefficients of the ground are chosen and varied.
struct RestitutionLaw {
    bool fitted = true;   ///< shipped ground types with fitted coefficients; no: with published ones
    bool damping = true;  ///< both fall with impact speed, as the law of damping says
    /// Speed into the ground that halves the normal coefficient [m/s]; 0: none.
    double normal_halved_mps = pfeiffer_bowen_mps;
    double tangential_noise = 0.0;  ///< half width of the uniform noise on the tangential coefficient [-]
    double loss_noise = 1.0;        ///< the same by what the ground takes, 1 - r_t [-]

    /// Half width of both together.
    [[nodiscard]] double noise_of(double tangential) const {
        return tangential_noise + loss_noise * (1.0 - tangential);
    }
};

/// No noise may turn a contact into a source of energy.
inline constexpr double largest_restitution = 0.99;

/// The tangential coefficient with its noise: `draw` on [-1, 1) (Rammer et al. 2010, section 2.4.1).
inline Restitution with_noise(Restitution published, double half_width, double draw) {
    return {published.normal, std::clamp(published.tangential + half_width * draw, 0.0, largest_restitution)};
}

}  // namespace rockfall
