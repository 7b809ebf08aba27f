#pragma once

#include <numbers>

#include "config/math/elementary.hpp"
#include "rockfall/motion/rigid/law.hpp"

namespace rockfall::rigid {

/// Depth of the scar of an impact [m]: 0.1 M^(1/3) M_e^-0.4 v_n^0.8 with mass in kg, strength of the soil in
/// kN/m2 and the speed into the ground in m/s (Lu et al. 2019, Eq. 11, as printed; it gives less than the
/// depths they list).
inline double scar_depth_m(double mass_kg, double soil_strength_kpa, double into_ground_mps) {
    return 0.1 * config::pow_of(mass_kg, 1.0 / 3.0) * config::pow_of(soil_strength_kpa, -0.4) *
           config::pow_of(into_ground_mps, 0.8);
}

/// Deceleration in a scar [m/s2]: (C_f + C_s) rho_s A v^2 / (2 m), over the area of the block below the
/// ground: depth times diameter, at most the section of the sphere of equal volume [choice].
inline double scar_drag_mps2(const ScarLaw& law, double mass_kg, double diameter_m, double depth_m,
                             double speed_mps) {
    const double whole_m2 = 0.25 * std::numbers::pi * diameter_m * diameter_m;
    const double area_m2 = std::min(whole_m2, depth_m * diameter_m);
    return 0.5 * law.drag_factor * law.soil_density_kgpm3 * area_m2 * speed_mps * speed_mps / mass_kg;
}

}  // namespace rockfall::rigid
