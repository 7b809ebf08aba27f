#pragma once

#include <Eigen/Core>

#include "rockfall/rock_mass/laws.hpp"
#include "rockfall/rock_mass/overlap.hpp"

namespace rockfall::rock_mass {

/// How a body moves that takes part in a contact.
struct Mover {
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();
    Eigen::Vector3d spin_radps = Eigen::Vector3d::Zero();

    [[nodiscard]] Eigen::Vector3d velocity_at(const Eigen::Vector3d& point_m) const {
        return velocity_mps + spin_radps.cross(point_m - centre_m);
    }
};

/// What a contact remembers from step to step.
struct ContactState {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();     ///< unit, to the second body
    Eigen::Vector3d point_m = Eigen::Vector3d::Zero();    ///< centre of pressure
    Eigen::Vector3d dashpot_n = Eigen::Vector3d::Zero();  ///< of the normal dashpot on the second body, there
    Eigen::Vector3d tilt_dashpot_nm = Eigen::Vector3d::Zero();  ///< its moment about that point
    double dashpot_nspm = 0.0;                           ///< its resistance, without the share for the step
    Eigen::Vector3d anchor_m = Eigen::Vector3d::Zero();  ///< where the two below act
    Eigen::Vector3d shear_n = Eigen::Vector3d::Zero();   ///< force of the shear spring on the second body
    Eigen::Vector3d shear_dashpot_n = Eigen::Vector3d::Zero();  ///< that of its dashpot
    double shear_stiffness_npm = 0.0;
    double torsion_nm = 0.0;            ///< moment of the torsion spring on the second body, about the normal
    double torsion_dashpot_nm = 0.0;    ///< that of its dashpot
    double torsion_stiffness_nm = 0.0;  ///< by radian
    double normal_energy_j = 0.0;       ///< under `pfc` alone: of the normal spring
    bool touching = false;
    SeparatingFace known;

    /// Of both springs that friction limits.
    [[nodiscard]] double shear_energy_j() const {
        const double shear_j =
            shear_stiffness_npm > 0.0 ? 0.5 * shear_n.squaredNorm() / shear_stiffness_npm : 0.0;
        const double torsion_j =
            torsion_stiffness_nm > 0.0 ? 0.5 * torsion_nm * torsion_nm / torsion_stiffness_nm : 0.0;
        return shear_j + torsion_j;
    }
};

/// The same contact with first and second body exchanged.
inline ContactState reversed(ContactState state) {
    state.normal = -state.normal;
    state.shear_n = -state.shear_n;
    state.dashpot_n = -state.dashpot_n;
    state.shear_dashpot_n = -state.shear_dashpot_n;
    state.tilt_dashpot_nm = -state.tilt_dashpot_nm;
    state.known.reverse();
    return state;
}

/// Force on the second body, and moments on both about their centres.
struct PairForce {
    Eigen::Vector3d force_n = Eigen::Vector3d::Zero();
    Eigen::Vector3d moment_on_first_nm = Eigen::Vector3d::Zero();
    Eigen::Vector3d moment_on_second_nm = Eigen::Vector3d::Zero();
};

/// Work that contacts took out of the motion since the last step.
struct Losses {
    double friction_j = 0.0;
    double dashpot_j = 0.0;
    void operator+=(const Losses& other) {
        friction_j += other.friction_j;
        dashpot_j += other.dashpot_j;
    }
};

/// What a contact is made of beside its overlap.
struct ContactPair {
    double foundation_npm3;    ///< c = E* / L
    double friction;           ///< [-]
    double effective_mass_kg;  ///< m1 m2 / (m1 + m2)
    double disc_area_m2;       ///< of the smaller block; used with Laws::disc_areas
    double dashpot_share;      ///< of dashpots that a step of finite length leaves [-] (`dashpot_share`)
};

/// Share of each dashpot that a step leaves, where all dashpots of both blocks would take their motion at a
/// rate [1/s].
///
/// A dashpot acts with the velocity of half a step ago, before it has braked itself: by c / (1 - c dt / 2 m)
/// of what it should. That is taken back. At long steps more is: with springs whose critical step is dt / f
/// and dashpots of the rate s, motion that changes its sign in each step dies out if 4 f^2 + s dt < 2. Else a
/// block with many contacts is shaken by its dashpots for ever, by several times its weight.
inline double dashpot_share(double step_factor, double step_s, double rate_ps) {
    return 1.0 / (1.0 + step_s * rate_ps / (2.0 - 4.0 * step_factor * step_factor));
}

/// The whole force of a contact: normal force of the overlap, dashpot, friction.
///
/// - Normal: c times the overlap's force (`foundation`), or one spring k_n = c A at the middle of the contact
///   polygon, compressed by the mean depth (`pfc`).
/// - Dashpot: 2 beta sqrt(m_eff k_n) times the speed of approach; the normal force never pulls. It is spread
///   over the contact as the pressure is: where blocks tilt against each other it takes motion by c p^2, with
///   p the root mean square of the pressure's distance from its centre, as far as the pressure holds the
///   moment (`foundation`). Else a slab that leans on two places rocks on for a minute. Likewise along the
///   contact and about its normal, with k_s and k_s R^2, as far as friction holds them beside the springs.
/// - Friction: a spring k_s = k_n / ratio along the contact (Cundall & Strack 1979, Geotechnique 29:47), and
///   one of k_s R^2 about its normal. R is the mean distance of the pressure from its centre: mu N R is what
///   friction holds against spin alone. Force F and moment M about that centre slide together where
///   F^2 + (M / R)^2 exceeds (mu N)^2 (Howe & Cutkosky 1996, Int. J. Robot. Res. 15:557): a block that slides
///   is hardly kept from turning, and one that turns not from sliding. `pfc` has no spring about the normal.
///   Both act at an anchor: the matter where they were stretched, at most R from the centre of pressure; it
///   goes there where they slide. A force that went sideways with the pressure would let blocks that rock and
///   turn feed themselves. Both turn with the pair; where their stiffness falls their force falls with it, so
///   that a shrinking contact gives no energy back that it does not hold (Thornton et al. 2013, Powder
///   Technol. 233:30).
///
/// Velocities are those between the last place and this one, half a step ago. Work of friction and dashpots
/// is booked with them at the old and at the new force, half each: what velocity Verlet makes of a force.
/// Friction is booked exactly: its work minus what the spring holds more than before.
PairForce contact_force(const Laws& laws, const ContactPair& pair, const Mover& first, const Mover& second,
                        const Eigen::Vector3d& about_m, const Overlap& overlap, double step_s,
                        ContactState& state, Losses& losses);

/// Books what a contact held that is no more.
void end_contact(const Mover& first, const Mover& second, double step_s, ContactState& state, Losses& losses);

}  // namespace rockfall::rock_mass
