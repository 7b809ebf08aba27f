#pragma once

#include <Eigen/Core>

#include "config/random/stream.hpp"
#include "rockfall/laws/contact.hpp"
#include "rockfall/laws/restitution.hpp"
#include "rockfall/laws/rock.hpp"
#include "rockfall/motion/picus/law.hpp"
#include "rockfall/slope/slope.hpp"

namespace rockfall::picus {

/// What is drawn at one ground contact.
struct ContactDraws {
    double noise = 0.0;    ///< on [-1, 1)
    double lateral = 0.0;  ///< on [-1, 1)
    double stop = 1.0;     ///< on [0, 1)
    double angle = 0.0;    ///< standard normal, cut at two deviations
    double facet = 0.5;    ///< on [0, 1), which facet it meets
};

/// The draws of a contact from four uniforms. The normal deviate takes longer than all others: it is made
/// only for a law with scatter.
ContactDraws contact_draws(const config::FourUniforms& uniforms, const Law& law);

/// Meets the ground with a velocity into it: restitution, jump angle, deviation, chance to stop, change to
/// rolling.
///
/// `jump_angle_factor` is that of the ground type; `friction` its rolling friction, 0 for that of the law: on
/// flatter ground slow rocks rest. Kinetic energy never rises; the spin takes what the speed
/// leaves of it, at most that of rolling. Requires velocity . normal < 0 and a unit normal.
Contact meet_ground(const Eigen::Vector3d& velocity_mps, double spin_radps, const Eigen::Vector3d& normal,
                    Restitution published, double stop_probability, const Rock& rock, const Law& law,
                    const ContactDraws& draws, double jump_angle_factor = 1.0, double friction = 0.0);

/// A rock that would brake harder slides: the least sliding friction of loose ground (Cottaz et al. 2010,
/// Table 2).
inline constexpr double largest_rolling_friction = 0.6;

/// Friction of a rolling rock that loses so many times what the usual one does [-]: that of the ground type,
/// else that of the law.
double rolling_friction(const SurfaceType& surface, const Law& law, double loss_factor);

/// Velocity of a rolling rock that lifts off by itself, at the angle of the jump-angle law.
Eigen::Vector3d lift_off(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& normal, const Law& law,
                         const ContactDraws& draws, double jump_angle_factor = 1.0);

/// Speeds at which a rock begins to roll and to jump on a plane: factor * sqrt(g R cos b).
double rolling_speed_scale_mps(double normal_z, double radius_m);

}  // namespace rockfall::picus
