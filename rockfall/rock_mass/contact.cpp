#include "rockfall/rock_mass/contact.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace rockfall::rock_mass {

using Eigen::Vector3d;

namespace {

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

/// Half of the work of the last step's forces on the way from there to here.
Losses half_work_of_old(const Mover& first, const Mover& second, double step_s, const ContactState& state) {
    if (!state.touching) {
        return {};
    }
    const Vector3d way_m =
        0.5 * step_s * (second.velocity_at(state.point_m) - first.velocity_at(state.point_m));
    return {-state.shear_n.dot(way_m), -state.dashpot_n.dot(way_m)};
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
    const double shear_stiffness_npm = stiffness_npm / laws.stiffness_ratio;
    const double elastic_n =
        pfc ? stiffness_npm * overlap_m3 / polygon_m2 : pair.foundation_npm3 * overlap_m3;
    const Vector3d point_m = about_m + (pfc ? overlap.surface_centre_m() : overlap.pressure_centre_m());

    const Vector3d slip_mps = second.velocity_at(point_m) - first.velocity_at(point_m);
    const double parting_mps = slip_mps.dot(normal);
    const Vector3d along_mps = slip_mps - parting_mps * normal;
    const double dashpot_n =
        std::max(-elastic_n,
                 -2.0 * laws.damping_ratio * std::sqrt(pair.effective_mass_kg * stiffness_npm) * parting_mps);
    const double most_shear_n = pair.friction * (elastic_n + dashpot_n);

    const Vector3d held_n = turned_shear(state, normal, first, second, shear_stiffness_npm, step_s);
    Vector3d shear_n = held_n - shear_stiffness_npm * step_s * along_mps;
    const double shear_size_n = shear_n.norm();
    const bool sticks = shear_size_n <= most_shear_n;
    if (!sticks) {
        shear_n *= most_shear_n / shear_size_n;
    }
    Vector3d damping_n = dashpot_n * normal;
    if (sticks) {
        const Vector3d along_n =
            -2.0 * laws.damping_ratio * std::sqrt(pair.effective_mass_kg * shear_stiffness_npm) * along_mps;
        if ((shear_n + along_n).norm() <= most_shear_n) {
            damping_n += along_n;
        }
    }

    Losses lost = half_work_of_old(first, second, step_s, state);
    lost.friction_j += state.shear_energy_j() - 0.5 * step_s * shear_n.dot(slip_mps);
    lost.dashpot_j -= 0.5 * step_s * damping_n.dot(slip_mps);
    state.normal = normal;
    state.shear_n = shear_n;
    state.dashpot_n = damping_n;
    state.point_m = point_m;
    state.shear_stiffness_npm = shear_stiffness_npm;
    state.normal_energy_j = pfc ? 0.5 * elastic_n * elastic_n / stiffness_npm : 0.0;
    state.touching = true;
    lost.friction_j -= state.shear_energy_j();
    losses += lost;

    // The foundation's force with its exact moment; the rest acts at the point.
    const Vector3d elastic = elastic_n * normal;
    const Vector3d at_point_n = shear_n + damping_n + (pfc ? elastic : Vector3d::Zero());
    PairForce result;
    result.force_n = elastic + shear_n + damping_n;
    const Vector3d spread_n = pfc ? Vector3d::Zero() : elastic;
    const Vector3d moment_nm = pfc ? Vector3d::Zero() : Vector3d{pair.foundation_npm3 * overlap.moment_m4};
    const auto moment_about = [&](const Vector3d& centre_m) {
        return Vector3d{moment_nm + (about_m - centre_m).cross(spread_n) +
                        (point_m - centre_m).cross(at_point_n)};
    };
    result.moment_on_second_nm = moment_about(second.centre_m);
    result.moment_on_first_nm = -moment_about(first.centre_m);
    return result;
}

void end_contact(const Mover& first, const Mover& second, double step_s, ContactState& state,
                 Losses& losses) {
    if (!state.touching) {
        return;
    }
    Losses lost = half_work_of_old(first, second, step_s, state);
    lost.friction_j += state.shear_energy_j();
    losses += lost;
    const SeparatingFace known = state.known;
    const double free_way_m = state.free_way_m;
    state = {};
    state.known = known;
    state.free_way_m = free_way_m;
}

}  // namespace rockfall::rock_mass
