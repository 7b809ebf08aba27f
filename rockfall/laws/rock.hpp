#pragma once

#include <numbers>

namespace rockfall {

/// A spherical rock.
struct Rock {
    double diameter_m = 1.0;
    double radius_m = 0.5;
    double mass_kg = 0.0;
    double inertia_kgm2 = 0.0;  ///< about any axis through the centre
    double elongation = 2.0;    ///< longest side of the real rock by its shortest [-], >= 1
    double own_losses = 0.0;    ///< standard normal deviate of what it loses at contacts, see losses.hpp

    static constexpr Rock sphere(double diameter_m, double density_kgpm3) {
        const double mass_kg = density_kgpm3 * std::numbers::pi / 6.0 * diameter_m * diameter_m * diameter_m;
        const double radius_m = 0.5 * diameter_m;
        return {diameter_m, radius_m, mass_kg, 0.4 * mass_kg * radius_m * radius_m, 2.0, 0.0};
    }
};

/// Kinetic energy of translation and rotation.
inline double kinetic_energy_j(const Rock& rock, double squared_speed, double spin_radps) {
    return 0.5 * rock.mass_kg * squared_speed + 0.5 * rock.inertia_kgm2 * spin_radps * spin_radps;
}

}  // namespace rockfall
