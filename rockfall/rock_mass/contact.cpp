#include "rockfall/rock_mass/contact.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace rockfall::rock_mass {

using Eigen::Vector3d;

namespace {

/// How fast the second body leaves the first one.
struct Parting {
    Vector3d centre_m;      ///< of the second body
    Vector3d velocity_mps;  ///< there
    Vector3d spin_radps;

    Parting(const Mover& first, const Mover& second)
        : centre_m{second.centre_m},
          velocity_mps{second.velocity_mps - first.velocity_at(second.centre_m)},
          spin_radps{second.spin_radps - first.spin_radps} {}

    [[nodiscard]] Vector3d at(const Vector3d& point_m) const {
        return velocity_mps + spin_radps.cross(point_m - centre_m);
    }
};

/// Springs along a contact and about its normal.
struct ContactSprings {
    double shear_npm;
    double torsion_nm;  ///< by radian
    double radius_m;    ///< where a force has the moment that counts as much
    Vector3d arm_m;     ///< from the centre of pressure to the anchor

    /// Product of two forces at the anchor with moments there, by which friction measures them: about the
    /// centre of pressure.
    [[nodiscard]] double product_n2(const Vector3d& normal, const Vector3d& a_n, double a_nm,
                                    const Vector3d& b_n, double b_nm) const {
        const double along_n2 = a_n.dot(b_n);
        if (radius_m <= 0.0) {
            return along_n2;
        }
        const Vector3d turned_m = normal.cross(arm_m);
        return along_n2 + (a_nm + turned_m.dot(a_n)) * (b_nm + turned_m.dot(b_n)) / (radius_m * radius_m);
    }
};

/// Where the springs act: at the matter of both bodies at which they were stretched, carried on by a step,
/// in the plane of the contact and among its pressure.
Vector3d carried_anchor_m(const ContactState& state, const Mover& second, const Vector3d& at_anchor_mps,
                          const Vector3d& normal, const Vector3d& centre_m, double radius_m, double step_s) {
    if (!state.touching) {
        return centre_m;
    }
    const Vector3d moved_m = step_s * (second.velocity_at(state.anchor_m) - 0.5 * at_anchor_mps);
    Vector3d arm_m = state.anchor_m + moved_m - centre_m;
    arm_m -= arm_m.dot(normal) * normal;
    const double length_m = arm_m.norm();
    return length_m > radius_m ? Vector3d{centre_m + radius_m / length_m * arm_m} : centre_m + arm_m;
}

/// The shear force of the last step, turned with the pair and cut to what a smaller contact holds.
Vector3d turned_shear(const ContactState& state, const Vector3d& normal, const Mover& first,
                      const Mover& second, double stiffness_npm, double step_s) {
    if (!state.touching || state.shear_n.isZero(0.0)) {
        return Vector3d::Zero();
    }
    const double size_n = state.shear_n.norm();
    const double spin = 0.5 * (first.spin_radps + second.spin_radps).dot(normal);
    Vector3d turned = state.shear_n + spin * step_s * normal.cross(state.shear_n);
    turned -= turned.dot(normal) * normal;
    const double length = turned.norm();
    if (length <= 0.0) {
        return Vector3d::Zero();
    }
    const double held = std::min(1.0, stiffness_npm / state.shear_stiffness_npm);
    return turned * (held * size_n / length);
}

/// The torsion of the last step, cut in the same way.
double held_torsion_nm(const ContactState& state, double stiffness_nm) {
    if (!state.touching || state.torsion_nm == 0.0) {
        return 0.0;
    }
    return state.torsion_nm * std::min(1.0, stiffness_nm / state.torsion_stiffness_nm);
}

/// Half of the work of a step's forces on the way of a step.
Losses half_work(const Parting& parting, const Vector3d& at_anchor_mps, double step_s,
                 const ContactState& state) {
    const double half_s = 0.5 * step_s;
    const double spin_radps = parting.spin_radps.dot(state.normal);
    const double dashpots_w =
        state.dashpot_n.dot(parting.at(state.point_m)) + state.shear_dashpot_n.dot(at_anchor_mps) +
        state.torsion_dashpot_nm * spin_radps + parting.spin_radps.dot(state.tilt_dashpot_nm);
    return {-half_s * (state.shear_n.dot(at_anchor_mps) + state.torsion_nm * spin_radps),
            -half_s * dashpots_w};
}

/// Stretches the springs by the motion of a step, and lets them slide where they pull more than friction
/// holds: then they go to the centre of pressure. Dashpots add as much as friction holds beside the springs.
void drag(const ContactSprings& springs, const Vector3d& slip_mps, double spin_radps, double most_n,
          double resistance_nspm, double step_s, ContactState& state) {
    const Vector3d& normal = state.normal;
    const Vector3d along_mps = slip_mps - slip_mps.dot(normal) * normal;
    state.shear_n -= springs.shear_npm * step_s * along_mps;
    state.torsion_nm -= springs.torsion_nm * step_s * spin_radps;
    state.shear_dashpot_n.setZero();
    state.torsion_dashpot_nm = 0.0;
    const double springs_n2 =
        springs.product_n2(normal, state.shear_n, state.torsion_nm, state.shear_n, state.torsion_nm);
    const double left_n2 = most_n * most_n - springs_n2;
    if (left_n2 <= 0.0) {
        const double share = springs_n2 > 0.0 ? most_n / std::sqrt(springs_n2) : 0.0;
        state.shear_n *= share;
        state.torsion_nm *= share;
        state.anchor_m = state.point_m;
        return;
    }
    const Vector3d along_n = -resistance_nspm * along_mps;
    const double about_nm = -resistance_nspm * springs.radius_m * springs.radius_m * spin_radps;
    const double both_n2 = springs.product_n2(normal, state.shear_n, state.torsion_nm, along_n, about_nm);
    const double dashpots_n2 = springs.product_n2(normal, along_n, about_nm, along_n, about_nm);
    if (dashpots_n2 <= 0.0) {
        return;
    }
    const double share =
        std::min(1.0, (std::sqrt(both_n2 * both_n2 + dashpots_n2 * left_n2) - both_n2) / dashpots_n2);
    state.shear_dashpot_n = share * along_n;
    state.torsion_dashpot_nm = share * about_nm;
}

/// Moment of the dashpot where it is spread as the pressure is, on the second body that tilts; an even
/// pressure of a rectangle that sums up to `most_n` pulls nowhere.
Vector3d tilt_dashpot_nm(const std::array<Vector3d, 2>& arms_m, const Vector3d& normal,
                         const Vector3d& spin_radps, double resistance_nspm, double most_n) {
    const Vector3d tilt = normal.cross(spin_radps);
    const double first_n = resistance_nspm * arms_m[0].dot(tilt);
    const double second_n = resistance_nspm * arms_m[1].dot(tilt);
    const double both_n = std::sqrt(first_n * first_n + second_n * second_n);
    if (both_n <= 0.0) {
        return Vector3d::Zero();
    }
    return std::min(1.0, most_n / (std::numbers::sqrt3 * both_n)) *
           normal.cross(first_n * arms_m[0] + second_n * arms_m[1]);
}

}  // namespace

PairForce contact_force(const Laws& laws, const ContactPair& pair, const Mover& first, const Mover& second,
                        const Vector3d& about_m, const Overlap& overlap, double step_s, ContactState& state,
                        Losses& losses) {
    const bool pfc = laws.contact == ContactLaw::pfc;
    const double overlap_m3 = overlap.force_m3.norm();
    const Vector3d normal = overlap.force_m3 / overlap_m3;
    const double polygon_m2 = overlap.area_m2.norm();
    const double area_m2 = pfc && laws.disc_areas ? pair.disc_area_m2 : polygon_m2;
    const double stiffness_npm = pair.foundation_npm3 * area_m2;
    const double elastic_n =
        pfc ? stiffness_npm * overlap_m3 / polygon_m2 : pair.foundation_npm3 * overlap_m3;
    const Vector3d point_m = about_m + (pfc ? overlap.surface_centre_m() : overlap.pressure_centre_m());
    const double shear_npm = stiffness_npm / laws.stiffness_ratio;
    const double radius_m = pfc ? 0.0 : overlap.friction_radius_m;
    const double damping = 2.0 * laws.damping_ratio;
    const double dashpot_nspm = damping * std::sqrt(pair.effective_mass_kg * stiffness_npm);
    const Parting parting{first, second};
    const double dashpot_n =
        std::max(-elastic_n, -pair.dashpot_share * dashpot_nspm * parting.at(point_m).dot(normal));

    Losses lost;
    Vector3d at_anchor_mps = Vector3d::Zero();
    if (state.touching) {
        at_anchor_mps = parting.at(state.anchor_m);
        lost = half_work(parting, at_anchor_mps, step_s, state);
        lost.friction_j += state.shear_energy_j();
    }
    const double torsion_nm = shear_npm * radius_m * radius_m;
    state.anchor_m = carried_anchor_m(state, second, at_anchor_mps, normal, point_m, radius_m, step_s);
    state.shear_n = turned_shear(state, normal, first, second, shear_npm, step_s);
    state.torsion_nm = held_torsion_nm(state, torsion_nm);
    state.shear_stiffness_npm = shear_npm;
    state.torsion_stiffness_nm = torsion_nm;
    state.normal = normal;
    state.point_m = point_m;
    state.dashpot_n = dashpot_n * normal;
    state.dashpot_nspm = dashpot_nspm;
    state.tilt_dashpot_nm = pfc ? Vector3d{Vector3d::Zero()}
                                : tilt_dashpot_nm(overlap.arms_m, normal, parting.spin_radps,
                                                  pair.dashpot_share * dashpot_nspm, elastic_n + dashpot_n);
    state.normal_energy_j = pfc ? 0.5 * elastic_n * elastic_n / stiffness_npm : 0.0;
    state.touching = true;
    at_anchor_mps = parting.at(state.anchor_m);
    drag({shear_npm, torsion_nm, radius_m, state.anchor_m - point_m}, at_anchor_mps,
         parting.spin_radps.dot(normal), pair.friction * (elastic_n + dashpot_n),
         pair.dashpot_share * damping * std::sqrt(pair.effective_mass_kg * shear_npm), step_s, state);
    lost.friction_j -= state.shear_energy_j();
    lost += half_work(parting, parting.at(state.anchor_m), step_s, state);
    losses += lost;

    // The foundation's force with its exact moment; the rest acts at the point.
    const Vector3d elastic = elastic_n * normal;
    const Vector3d along_n = state.shear_n + state.shear_dashpot_n;
    const Vector3d at_point_n = pfc ? Vector3d{state.dashpot_n + elastic} : state.dashpot_n;
    const Vector3d spread_n = pfc ? Vector3d{Vector3d::Zero()} : elastic;
    Vector3d moment_nm = (state.torsion_nm + state.torsion_dashpot_nm) * normal + state.tilt_dashpot_nm;
    if (!pfc) {
        moment_nm += pair.foundation_npm3 * overlap.moment_m4;
    }
    PairForce result;
    result.force_n = elastic + state.dashpot_n + along_n;
    result.moment_on_second_nm = moment_nm + (about_m - second.centre_m).cross(spread_n) +
                                 (point_m - second.centre_m).cross(at_point_n) +
                                 (state.anchor_m - second.centre_m).cross(along_n);
    result.moment_on_first_nm =
        (first.centre_m - second.centre_m).cross(result.force_n) - result.moment_on_second_nm;
    return result;
}

void end_contact(const Mover& first, const Mover& second, double step_s, ContactState& state,
                 Losses& losses) {
    if (!state.touching) {
        return;
    }
    const Parting parting{first, second};
    Losses lost = half_work(parting, parting.at(state.anchor_m), step_s, state);
    lost.friction_j += state.shear_energy_j();
    losses += lost;
    const SeparatingFace known = state.known;
    state = {};
    state.known = known;
}

}  // namespace rockfall::rock_mass
