#include "rockfall/motion/picus/ground_contact.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "config/math/elementary.hpp"
#include "config/random/distributions.hpp"
#include "config/units/constants.hpp"
#include "rockfall/laws/hop.hpp"
#include "rockfall/motion/picus/hop_share.hpp"
#include "rockfall/motion/picus/impact_friction.hpp"
#include "rockfall/motion/picus/johnson_damping.hpp"
#include "rockfall/motion/picus/normal_damping.hpp"
#include "rockfall/motion/picus/steep_impact.hpp"

namespace rockfall::picus {
namespace {

/// Spin after a contact: that of rolling along the ground, as far as energy allows.
double spin_after(const Rock& rock, double energy_before_j, double squared_speed_after,
                  double along_slope_mps) {
    const double left_j = std::max(0.0, energy_before_j - 0.5 * rock.mass_kg * squared_speed_after);
    const double rolling_radps = along_slope_mps / rock.radius_m;
    return 0.5 * rock.inertia_kgm2 * rolling_radps * rolling_radps <= left_j
               ? rolling_radps
               : std::sqrt(2.0 * left_j / rock.inertia_kgm2);
}

/// Whether rocks do not begin to roll by themselves: the tangent of the slope lies below the friction.
bool holds_rocks(const Eigen::Vector3d& normal, double friction) {
    const double squared_cosine = normal.z() * normal.z();
    return 1.0 - squared_cosine < friction * friction * squared_cosine;
}

/// Goes over to rolling with the tangential part of the impact.
Contact begin_rolling(const Impact& impact, const Eigen::Vector3d& direction, double tangential_restitution,
                      double energy_before_j, const Rock& rock) {
    // A rolling sphere holds 0.7 m v^2; the impact may not have brought that much if the rock did not spin.
    const double affordable_mps = std::sqrt(energy_before_j / (0.7 * rock.mass_kg));
    const double speed_mps = std::min(tangential_restitution * impact.along_slope_mps, affordable_mps);
    return {Onward::rolls, speed_mps * direction, speed_mps / rock.radius_m};
}

/// Friction of rolling of the ground, or that of the law where the ground has none of its own.
double friction_of(double of_ground, const Law& law) {
    return of_ground > 0.0 ? of_ground : law.rolling.friction;
}

double factor_of(const Law& law, double jump_angle_factor) {
    return law.jump_angle_by_ground ? jump_angle_factor : 1.0;
}

/// For how many impacts of the published law this one stands.
double impacts_of(const Contact& contact, const Eigen::Vector3d& normal, const Law& law) {
    if (contact.onward != Onward::flies || !law.stops_by_hop_length || law.angle == ReboundAngle::geometric) {
        return 1.0;
    }
    return hop_share(contact.velocity_mps, normal,
                     jump_angle(contact.velocity_mps.squaredNorm(), law.jump_angle));
}

Eigen::Vector3d velocity_off_ground(const Impact& impact, Restitution restitution, double speed_mps,
                                    const Eigen::Vector3d& direction, const Eigen::Vector3d& normal,
                                    const Law& law, double angle_draw, double jump_angle_factor) {
    if (law.angle == ReboundAngle::geometric) {
        return restitution.tangential * impact.along_slope_mps * direction +
               restitution.normal * impact.into_ground_mps * normal;
    }
    const config::Angle angle =
        jump_angle(speed_mps * speed_mps, law.jump_angle, angle_draw, factor_of(law, jump_angle_factor));
    const double steep_share = law.blend_steep_impacts ? steepness_share(impact) : 0.0;
    if (steep_share > 0.0) {
        const Eigen::Vector2d blend = blended_direction(angle, impact, restitution, steep_share);
        return speed_mps * (blend.x() * direction + blend.y() * normal);
    }
    return rebound(speed_mps, angle, direction, normal);
}

/// What the impact on a face does unless the ground catches the rock. Where the rock rests, rolls or flies on
/// is a matter of the ground, whose normal is `ground`: a facet may be level or overhang.
Contact go_on(const Eigen::Vector3d& velocity_mps, double spin_radps, const Eigen::Vector3d& normal,
              const Eigen::Vector3d& ground, Restitution published, const Rock& rock, const Law& law,
              const ContactDraws& draws, double jump_angle_factor, double friction) {
    const double squared_speed = velocity_mps.squaredNorm();
    const double energy_before_j = kinetic_energy_j(rock, squared_speed, spin_radps);
    const Impact impact = split(velocity_mps, normal);
    const double noise = law.noise == NoiseScope::off ? 0.0 : law.restitution.noise_of(published.tangential);
    const Restitution noisy = with_noise(published, noise, draws.noise);
    const Restitution restitution =
        at_normal_speed(law.restitution.damping ? at_impact_speed(noisy, squared_speed) : noisy,
                        impact.into_ground_mps, law.restitution.normal_halved_mps);
    const double speed_mps = speed_after(impact, restitution);
    const config::Angle deviation = config::Angle::from_radians(
        draws.lateral * largest_deviation(std::sqrt(squared_speed), law.lateral).in_radians());
    const Eigen::Vector3d direction = turned(impact.direction, normal, deviation);

    if (speed_mps < law.stopping.slow_mps && holds_rocks(ground, friction_of(friction, law))) {
        return {Onward::rests, Eigen::Vector3d::Zero(), 0.0};
    }
    if (speed_mps < law.rolling.start_factor * rolling_speed_scale_mps(ground.z(), rock.radius_m)) {
        return begin_rolling(impact, direction, restitution.tangential, energy_before_j, rock);
    }
    const Eigen::Vector3d leaving_mps = velocity_off_ground(impact, restitution, speed_mps, direction, normal,
                                                            law, draws.angle, jump_angle_factor);
    if (leaving_mps.dot(ground) <= 0.0 || !hops_far(leaving_mps, ground, rock.radius_m)) {
        return begin_rolling(impact, direction, restitution.tangential, energy_before_j, rock);
    }
    return {Onward::flies, leaving_mps,
            spin_after(rock, energy_before_j, speed_mps * speed_mps,
                       restitution.tangential * impact.along_slope_mps)};
}

}  // namespace

ContactDraws contact_draws(const config::FourUniforms& uniforms, const Law& law) {
    static const config::TruncatedNormal within_two_deviations{2.0};
    const double angle = law.jump_angle.scatter > 0.0 ? within_two_deviations(uniforms[3]) : 0.0;
    // Of 32 bits the upper ones decide the angle, the lower ones the facet.
    constexpr double upper = 65536.0;
    const double facet = uniforms[3] * upper - std::floor(uniforms[3] * upper);
    return {2.0 * uniforms[0] - 1.0, 2.0 * uniforms[1] - 1.0, uniforms[2], angle, facet};
}

double rolling_speed_scale_mps(double normal_z, double radius_m) {
    return std::sqrt(config::gravity_mps2 * radius_m * normal_z);
}

Contact meet_ground(const Eigen::Vector3d& velocity_mps, double spin_radps, const Eigen::Vector3d& normal,
                    Restitution published, double stop_probability, const Rock& rock, const Law& law,
                    const ContactDraws& draws, double jump_angle_factor, double friction) {
    const bool rough = law.facets.any();
    const Eigen::Vector3d face =
        rough ? facet_normal(velocity_mps, normal, law.facets.steepest(published.tangential), draws.facet)
              : normal;
    const Restitution restitution =
        law.impact_friction ? with_friction(published, velocity_mps, normal, friction_of(friction, law))
                            : published;
    Contact contact = go_on(velocity_mps, spin_radps, face, normal, restitution, rock, law, draws,
                            jump_angle_factor, friction);
    if (rough) {
        contact = on_ground(contact, normal);
    }
    // Most draws stop no rock however long its hop is: its length takes longer than all else here.
    if (law.stopping.by_chance && draws.stop < most_impacts_of_a_hop * stop_probability &&
        is_stopped(draws.stop, stop_probability, impacts_of(contact, normal, law))) {
        return {Onward::caught, Eigen::Vector3d::Zero(), 0.0};
    }
    return contact;
}

double rolling_friction(const SurfaceType& surface, const Law& law, double loss_factor) {
    // What shipped types say of it is fitted.
    const bool of_ground = surface.rolling_friction > 0.0 && (law.restitution.fitted || !surface.published);
    const double usual = of_ground ? surface.rolling_friction : law.rolling.friction;
    return std::min(usual * loss_factor, std::max(usual, largest_rolling_friction));
}

Eigen::Vector3d lift_off(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& normal, const Law& law,
                         const ContactDraws& draws, double jump_angle_factor) {
    const double speed_mps = velocity_mps.norm();
    return rebound(
        speed_mps,
        jump_angle(speed_mps * speed_mps, law.jump_angle, draws.angle, factor_of(law, jump_angle_factor)),
        velocity_mps / speed_mps, normal);
}

}  // namespace rockfall::picus
