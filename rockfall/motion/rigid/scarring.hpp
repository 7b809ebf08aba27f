#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "config/math/elementary.hpp"
#include "rockfall/motion/rigid/law.hpp"

namespace rockfall::rigid {

/// The scar that a block ploughs at an impact.
struct Scar {
    double depth_m = 0.0;
    double drag_pm = 0.0;  ///< share of the speed that is lost in a metre [1/m]
    double left_m = 0.0;   ///< way still to plough
};

/// Depth of the scar of an impact [m]: 0.1 M^(1/3) M_e^-0.4 v_n^0.8 with mass in kg, strength of the soil in
/// kN/m2 and the speed into the ground in m/s (Lu et al. 2019, Eq. 11, as printed; it gives less than the
/// depths they list).
inline double scar_depth_m(double mass_kg, double soil_strength_kpa, double into_ground_mps) {
    return 0.1 * config::pow_of(mass_kg, 1.0 / 3.0) * config::pow_of(soil_strength_kpa, -0.4) *
           config::pow_of(into_ground_mps, 0.8);
}

/// Chord of the sphere of equal volume at a depth [m].
inline double chord_m(double diameter_m, double depth_m) {
    const double sunk_m = std::min(depth_m, 0.5 * diameter_m);
    return 2.0 * std::sqrt(sunk_m * (diameter_m - sunk_m));
}

/// The scar of one impact. The soil takes (C_f + C_s) rho_s A v^2 / 2 (Lu et al. 2019) over the section A of
/// the block below the ground: depth times width, at most that of the sphere of equal volume. The width is
/// that of the contacts across the way, `across_m`, and the chord of the sphere around them; the scar is as
/// long as that chord [choice].
inline Scar scar_of(const ScarLaw& law, double mass_kg, double diameter_m, double soil_strength_kpa,
                    double into_ground_mps, double across_m) {
    const double depth_m = scar_depth_m(mass_kg, soil_strength_kpa, into_ground_mps);
    const double length_m = chord_m(diameter_m, depth_m);
    const double width_m = std::min(diameter_m, across_m + length_m);
    const double area_m2 = std::min(depth_m * width_m, 0.25 * std::numbers::pi * diameter_m * diameter_m);
    return {depth_m, 0.5 * law.drag_factor * law.soil_density_kgpm3 * area_m2 / mass_kg, length_m};
}

}  // namespace rockfall::rigid
