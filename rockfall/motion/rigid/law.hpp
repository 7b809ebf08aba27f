#pragma once

#include <cstdint>
#include <optional>

#include "rockfall/motion/rigid/ground.hpp"
#include "rockfall/motion/rigid/percussion.hpp"

namespace rockfall::rigid {

/// How blocks begin (start.hpp).
enum class StartKind : std::uint8_t {
    by_height,  ///< falling where release.height_m is above 0, else sliding
    falling,    ///< in the air, attitude at random or given
    sliding,    ///< lying on the ground, with release.speed_mps
    toppling,   ///< about the lower edge of the face on which it stands
};

/// Drag in the scar that a block ploughs (scarring.hpp).
struct ScarLaw {
    bool on = true;
    double drag_factor = 4.0;            ///< C_f + C_s [-]
    double soil_density_kgpm3 = 1500.0;  ///< rho_s
};

/// The settings of rigid blocks; sources in parameters.cpp and README.md.
struct Law {
    // What replaces the figures of all ground types; below 0: those of the types.
    std::optional<FrictionLaw> friction_law;
    double friction = -1.0;
    double friction_max = -1.0;
    double restitution = -1.0;
    double rolling_resistance = -1.0;
    double slip_beta_ps = -1.0;
    double slip_kappa_pm = -1.0;
    double drag_ps = -1.0;
    double soil_strength_kpa = -1.0;
    double roughness_m = -1.0;

    double restitution_halved_mps = 9.144;  ///< e halves at this speed into the ground [m/s]; 0: never
    double plastic_mps = 0.03;              ///< slower impacts have e = 0
    bool stops_by_chance = false;           ///< stop probabilities of the ground types
    ScarLaw scar;
    bool double_friction = false;  ///< twice mu where two or more points touch, as PhysX applies it
    double spin_cap_radps = 0.0;   ///< no spin is faster; 0: no cap
    double step_s = 1e-3;          ///< of lasting contact
    double rest_mps = 0.02;  ///< in the mean over rest_s; a block that is slower, and does not gain, rests
    double rest_s = 0.3;
    double longest_s = 600.0;  ///< a block that moves longer is given up
    SolverLaw solver;
    std::uint32_t most_impacts = 20'000;
    bool in_plane = false;  ///< runs along a profile: blocks keep their plane

    StartKind start = StartKind::by_height;
    double start_spin_radps = 0.0;  ///< of falling blocks, forwards about the horizontal across their heading
    double topple_spin_radps = 0.5;  ///< with which toppling blocks turn on
    bool keeps_attitude = false;     ///< sliding blocks keep the attitude given in [release]
};

/// The figures of a ground type with what the settings replace.
inline Ground ground_under(const Law& law, const Ground& of_type) {
    Ground ground = of_type;
    const auto take = [](double setting, double& figure) {
        if (setting >= 0.0) {
            figure = setting;
        }
    };
    if (law.friction_law) {
        ground.law = *law.friction_law;
    }
    take(law.friction, ground.friction);
    take(law.friction_max, ground.friction_max);
    take(law.restitution, ground.restitution);
    take(law.rolling_resistance, ground.rolling_resistance);
    take(law.slip_beta_ps, ground.slip_beta_ps);
    take(law.slip_kappa_pm, ground.slip_kappa_pm);
    take(law.drag_ps, ground.drag_ps);
    take(law.soil_strength_kpa, ground.soil_strength_kpa);
    if (ground.friction_max < ground.friction) {
        ground.friction_max = ground.friction;
    }
    return ground;
}

/// Roughness of the ground below the cells of the terrain [m]: of the settings, else of the ground type.
inline double roughness_of(const Law& law, double of_type_m) {
    return law.roughness_m >= 0.0 ? law.roughness_m : of_type_m;
}

}  // namespace rockfall::rigid
