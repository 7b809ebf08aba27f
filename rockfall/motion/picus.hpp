#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "config/random/stream.hpp"
#include "rockfall/motion/contact.hpp"
#include "rockfall/motion/ground_deviation.hpp"
#include "rockfall/motion/jump_angle.hpp"
#include "rockfall/motion/rebound.hpp"
#include "rockfall/motion/restitution.hpp"
#include "rockfall/motion/rolling.hpp"
#include "rockfall/motion/stopping.hpp"
#include "rockfall/rock.hpp"

namespace rockfall {

/// How often the noise on the tangential coefficient is drawn again.
enum class NoiseScope : std::uint8_t { off, impact, rock };

/// The ground contact of PICUS Rock'n'Roll (Rammer et al. 2010) with its settings.
struct PicusLaw {
    RestitutionLaw restitution;
    NoiseScope noise = NoiseScope::impact;
    ReboundAngle angle = ReboundAngle::jump_angle_law;
    JumpAngleLaw jump_angle;
    bool blend_steep_impacts = true;
    LateralDeviation lateral;
    RollingLaw rolling;
    StoppingLaw stopping;
};

/// What is drawn at one ground contact.
struct ContactDraws {
    double noise = 0.0;    ///< on [-1, 1)
    double lateral = 0.0;  ///< on [-1, 1)
    double stop = 1.0;     ///< on [0, 1)
    double angle = 0.0;    ///< standard normal, cut at two deviations
};

/// The draws of a contact from four uniforms. The normal deviate takes longer than all others: it is made
/// only for a law with scatter.
ContactDraws contact_draws(const config::FourUniforms& uniforms, const PicusLaw& law);

/// Meets the ground with a velocity into it: restitution, jump angle, deviation, chance to stop, change to
/// rolling.
///
/// Kinetic energy never rises; the spin takes what the speed leaves of it, at most that of rolling.
/// Requires velocity . normal < 0 and a unit normal.
Contact meet_ground(const Eigen::Vector3d& velocity_mps, double spin_radps, const Eigen::Vector3d& normal,
                    Restitution published, double stop_probability, const Rock& rock, const PicusLaw& law,
                    const ContactDraws& draws);

/// Velocity of a rolling rock that lifts off by itself, at the angle of the jump-angle law.
Eigen::Vector3d lift_off(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& normal,
                         const PicusLaw& law, const ContactDraws& draws);

/// Whether the jump that a velocity leads to is at least so long, along the plane and if the plane went on
/// for ever, or so high above it.
bool hops_far(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& normal, double least_m);

/// Speeds at which a rock begins to roll and to jump on a plane: factor * sqrt(g R cos b).
double rolling_speed_scale_mps(double normal_z, double radius_m);

/// Kinetic energy of translation and rotation.
inline double kinetic_energy_j(const Rock& rock, double squared_speed, double spin_radps) {
    return 0.5 * rock.mass_kg * squared_speed + 0.5 * rock.inertia_kgm2 * spin_radps * spin_radps;
}

}  // namespace rockfall
