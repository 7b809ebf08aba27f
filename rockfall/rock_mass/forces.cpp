// The forces of a rock mass: joints, contacts, ground, stems, and its energies.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rockfall/rock_mass/rock_mass.hpp"

namespace rockfall::rock_mass {

using Eigen::Vector3d;

namespace {

/// Ways are summed with the spin at the end of each step: what of a gap is surely free [choice].
constexpr double sure_share_of_way = 0.98;

/// The overlap that presses one body, about its centre, as that which presses the other one about a place
/// `shift_m` further.
Overlap as_seen_by_the_other(Overlap overlap, const Vector3d& shift_m) {
    overlap.force_m3 = -overlap.force_m3;
    overlap.moment_m4 = -overlap.moment_m4 - shift_m.cross(overlap.force_m3);
    overlap.area_m2 = -overlap.area_m2;
    overlap.depth_m4 -= overlap.depth_m3 * shift_m;
    overlap.surface_m3 -= overlap.surface_m2 * shift_m;
    return overlap;
}

}  // namespace

ContactPair RockMass::contact_pair(std::uint32_t first, std::uint32_t second) const {
    const PairSide &a = sides_[first], &b = sides_[second];
    const double inverse_mass_sum = a.inverse_mass_pkg + b.inverse_mass_pkg;
    const double smaller = std::min(a.half_side_m, b.half_side_m);
    return {laws_.modulus_pa / (a.half_side_m + b.half_side_m), laws_.friction,
            inverse_mass_sum > 0.0 ? 1.0 / inverse_mass_sum : 0.0, std::numbers::pi * smaller * smaller,
            dashpot_share_of(a.dashpots_ps + b.dashpots_ps)};
}

ContactPair RockMass::ground_pair(std::uint32_t block) const {
    const double r = blocks_[block].half_side_m;
    return {laws_.modulus_pa / (2.0 * r), laws_.ground_friction, blocks_[block].mass_kg,
            std::numbers::pi * r * r, dashpot_share_of(blocks_[block].dashpots_ps)};
}

/// Error of the force of two blocks that matters to none of them, for c = 1 [m3].
double RockMass::slack_of(std::uint32_t first, std::uint32_t second) const {
    return held_share_of_weight * std::min(sides_[first].weight_n, sides_[second].weight_n) /
           contact_pair(first, second).foundation_npm3;
}

bool RockMass::is_free(const Watch& watch) const {
    const Eigen::Vector4d& first = places_m_[watch.first];
    const Eigen::Vector4d& second = places_m_[watch.second];
    const double free_m = watch.free_m - (first[3] + second[3] - watch.turned_m);
    return free_m > 0.0 &&
           (second.head<3>() - first.head<3>() - watch.between_m).squaredNorm() < free_m * free_m;
}

/// Which of two blocks holds their overlap: not a matter of their numbers.
bool RockMass::is_holder(std::uint32_t block, std::uint32_t other) const {
    const Block& a = blocks_[block];
    const Block& b = blocks_[other];
    if (a.mass_kg != b.mass_kg) {
        return a.mass_kg > b.mass_kg;
    }
    const Vector3d any_direction{0.371, 0.613, 0.698};
    return any_direction.dot(a.centre_m - b.centre_m) > 0.0;
}

/// The overlap of two blocks as it is clipped, held from now on; about the second one's centre.
Overlap RockMass::clipped(std::uint32_t first, std::uint32_t second, ContactState& state,
                          KeptOverlap& held) const {
    const PlacedBlock a = placed(first), b = placed(second);
    if (laws_.contact == ContactLaw::pfc || (held && !held->wants_slope())) {
        if (held) {
            held->skip();
        }
        return overlap_of(a, b, b.centre_m, state.known, nullptr, !state.touching);
    }
    const bool second_holds = is_holder(second, first);
    OverlapSlope slope;
    Overlap overlap;
    if (!second_holds) {
        overlap = overlap_of(a, b, b.centre_m, state.known, &slope, !state.touching);
    } else {
        state.known.reverse();
        overlap = overlap_of(b, a, a.centre_m, state.known, &slope, !state.touching);
        state.known.reverse();
    }
    if (!overlap.is_none()) {
        const std::uint32_t holder = second_holds ? second : first, other = second_holds ? first : second;
        if (!held) {
            held = std::make_unique<HeldOverlap>();
        }
        held->keep(overlap, slope, pose(holder), pose(other), std::min(a.radius_m, b.radius_m), second_holds,
                   slack_of(first, second));
    }
    return second_holds ? as_seen_by_the_other(overlap, b.centre_m - a.centre_m) : overlap;
}

/// The contact of two blocks: nothing where their spheres or a known face keep them apart. Returns how far
/// they may move against each other before they can meet; 0 if they touch.
double RockMass::touch(std::uint32_t first, std::uint32_t second, ContactState& state, PairForce& force,
                       KeptOverlap& held, ChunkSums& sums) const {
    const Moved& a = moved_[first];
    const Moved& b = moved_[second];
    const double reach_m = sides_[first].radius_m + sides_[second].radius_m;
    const auto press = [&](const Overlap& overlap) {
        force = contact_force(laws_, contact_pair(first, second), mover(first), mover(second), b.centre_m,
                              overlap, step_s_, state, sums.losses);
    };
    if (held && held->is_valid()) {
        const bool by_second = held->second_holds();
        Overlap overlap;
        if (held->carry_on(pose(by_second ? second : first), pose(by_second ? first : second), overlap)) {
            press(by_second ? as_seen_by_the_other(overlap, b.centre_m - a.centre_m) : overlap);
            return 0.0;
        }
    }
    force = {};
    double gap_m = (a.centre_m - b.centre_m).norm() - reach_m;
    if (gap_m < 0.0) {
        bool by_edges = false;
        gap_m = separation_m(state.known, placed(first), placed(second));
        if (gap_m < 0.0) {
            const Overlap overlap = clipped(first, second, state, held);
            if (!overlap.is_none()) {
                press(overlap);
                return 0.0;
            }
            gap_m = overlap.gap_m;
            by_edges = state.known.is_edge() || (gap_m <= 0.0 && overlap.surface_m2 <= 0.0);
        } else {
            by_edges = state.known.is_edge();
        }
        if (by_edges) {
            gap_m += way_into_edge_m(state.known, placed(first), placed(second), slack_of(first, second));
        }
    }
    end_contact(mover(first), mover(second), step_s_, state, sums.losses);
    return sure_share_of_way * gap_m;
}

double RockMass::force_of(Contact& contact, KeptOverlap& held, ChunkSums& sums) const {
    return touch(contact.first, contact.second, contact.state, contact.force, held, sums);
}

void RockMass::force_of(Joint& joint, KeptOverlap& held, ChunkSums& sums) {
    Bond& bond = joint.bond;
    if (stands(bond.first) && stands(bond.second)) {
        return;
    }
    if (!bond.intact) {
        touch(bond.first, bond.second, joint.state, joint.force, held, sums);
        return;
    }
    const PlacedStrain placed = strain_of(bond, pose(bond.first), pose(bond.second));
    const BondStress stress = bond_stress(bond.section, bond.stiffness, placed.strain);
    if (!laws_when_let_go_ && breaks(stress, bond.strength, laws_.strength_angle_tan)) {
        break_bond(joint, placed, stress, sums);
        if (!bond.intact) {
            return;
        }
    }
    joint.force = bond_force(bond, placed, mover(bond.first), mover(bond.second));
    if (laws_.bond_damping_ratio > 0.0) {
        const PairForce damping =
            bond_dashpot(bond, placed, mover(bond.first), mover(bond.second), laws_.bond_damping_ratio,
                         contact_pair(bond.first, bond.second).effective_mass_kg, step_s_, sums.losses);
        joint.force.force_n += damping.force_n;
        joint.force.moment_on_first_nm += damping.moment_on_first_nm;
        joint.force.moment_on_second_nm += damping.moment_on_second_nm;
    }
}

/// A bond breaks where it holds more energy than the contact that takes its place: fracture never gives any.
void RockMass::break_bond(Joint& joint, const PlacedStrain& placed, const BondStress& stress,
                          ChunkSums& sums) {
    Bond& bond = joint.bond;
    ContactState state;
    PairForce force;
    ChunkSums of_contact;
    KeptOverlap not_held;
    touch(bond.first, bond.second, state, force, not_held, of_contact);
    const double held_j = bond_energy(bond.section, bond.stiffness, placed.strain).sum_j();
    const double freed_j = held_j - contact_energy_j(bond.first, bond.second, state) - state.shear_energy_j();
    if (freed_j < 0.0) {
        return;
    }
    const Mover first = mover(bond.first), second = mover(bond.second);
    sums.losses.dashpot_j -=
        0.5 * step_s_ *
        bond.dashpot_n.dot(second.velocity_at(bond.point_m) - first.velocity_at(bond.point_m));
    sums.losses += of_contact.losses;
    sums.fracture_j += freed_j;
    (stress.tension_pa > bond.strength.tensile_pa ? sums.broken_by_tension : sums.broken_by_shear) += 1;
    bond.intact = false;
    joint.state = state;
    joint.force = force;
}

void RockMass::force_of_ground(std::uint32_t i, KeptOverlap& held, ChunkSums& sums) {
    Footing& footing = footings_[i];
    if (stands(i) || footing.prisms.empty()) {
        return;
    }
    if (ways_m_[i] < footing.free_way_m) {
        return;
    }
    const Block& block = blocks_[i];
    const auto press = [&](const Overlap& overlap) {
        footing.force = contact_force(laws_, ground_pair(i), Mover{}, mover(i), block.centre_m, overlap,
                                      step_s_, footing.state, sums.losses);
    };
    constexpr auto where_the_ground_is = [] {
        return BlockPose{Vector3d::Zero(), Eigen::Quaterniond::Identity()};
    };
    Overlap carried;
    if (held && held->is_valid() && held->carry_on(where_the_ground_is(), pose(i), carried)) {
        press(carried);
        return;
    }
    footing.force = {};
    double gap_m = block.centre_m.z() - block.radius_m - footing.highest_ground_m;
    if (gap_m < 0.0) {
        const bool hold = laws_.contact != ContactLaw::pfc && (!held || held->wants_slope());
        if (!hold && held) {
            held->skip();
        }
        OverlapSlope slope;
        const Overlap overlap =
            ground_.overlap_of(footing.prisms, placed(i), block.centre_m, hold ? &slope : nullptr);
        if (!overlap.is_none()) {
            footing.free_way_m = 0.0;
            if (hold) {
                if (!held) {
                    held = std::make_unique<HeldOverlap>();
                }
                held->keep(overlap, slope, where_the_ground_is(), pose(i), block.radius_m, false,
                           held_share_of_weight * block.weight_n / ground_pair(i).foundation_npm3);
            }
            press(overlap);
            return;
        }
        gap_m = overlap.gap_m;
    }
    end_contact(Mover{}, mover(i), step_s_, footing.state, sums.losses);
    footing.free_way_m = ways_m_[i] + sure_share_of_way * gap_m;
}

/// Sums the stored forces of a block in the order of its pairs.
void RockMass::gather(std::size_t i) {
    Block& block = blocks_[i];
    if (block.status != BlockStatus::moving && block.status != BlockStatus::asleep) {
        return;
    }
    if (watches_lone_) {
        block.alone_s = is_alone(i) ? block.alone_s + step_s_ : 0.0;
    }
    Vector3d force_n{0.0, 0.0, -block.weight_n};
    force_n += footings_[i].force.force_n;
    Vector3d moment_nm = footings_[i].force.moment_on_second_nm;
    double dashpots_ps = dashpot_rate_ps(static_cast<std::uint32_t>(i), footings_[i].state);
    for (std::uint32_t k = first_end_[i]; k < first_end_[i + 1]; ++k) {
        const EndLoad& end = ends_[k];
        if (end.holds) {
            force_n += end.force_n;
            moment_nm += end.moment_nm;
            dashpots_ps += end.dashpots_ps;
        }
    }
    block.force_n = force_n;
    block.moment_nm = moment_nm;
    block.dashpots_ps = sides_[i].dashpots_ps = dashpots_ps;
}

/// A stem takes the energy of the motion into it until it is broken; then it is no obstacle any more.
void RockMass::meet_stems() {
    for (const auto& [number, stem_number] : near_stems_) {
        Block& block = blocks_[number];
        StandingStem& stem = stems_[stem_number];
        if (stem.is_broken() || block.status != BlockStatus::moving) {
            continue;
        }
        const Vector3d axis_m{stem.x_m, stem.y_m, std::clamp(block.centre_m.z(), stem.ground_m, stem.top_m)};
        const PlacedBlock shape = placed(number);
        const auto nearest = std::max_element(
            shape.faces.begin(), shape.faces.end(),
            [&](const Plane3& a, const Plane3& b) { return a.height_m(axis_m) < b.height_m(axis_m); });
        if (nearest->height_m(axis_m) > stem.radius_m) {
            continue;
        }
        Vector3d towards{nearest->normal.x(), nearest->normal.y(), 0.0};
        if (towards.norm() < 0.1) {
            towards = {axis_m.x() - block.centre_m.x(), axis_m.y() - block.centre_m.y(), 0.0};
        }
        towards = towards.stableNormalized();
        const double speed_mps = block.velocity_mps.dot(towards);
        if (speed_mps <= 0.0) {
            continue;
        }
        const double motion_j = 0.5 * block.mass_kg * speed_mps * speed_mps;
        const double loss_j = std::min(motion_j, stem.strength_j - stem.taken_j);
        const double after_mps =
            std::sqrt(std::max(0.0, speed_mps * speed_mps - 2.0 * loss_j / block.mass_kg));
        block.velocity_mps += (after_mps - speed_mps) * towards;
        stem.taken_j += loss_j;
        taken_.trees_j += loss_j;
    }
}

double RockMass::contact_energy_j(std::uint32_t first, std::uint32_t second,
                                  const ContactState& state) const {
    if (!state.touching) {
        return 0.0;
    }
    if (laws_.contact == ContactLaw::pfc) {
        return state.normal_energy_j;
    }
    return contact_pair(first, second).foundation_npm3 * overlap_energy_m4(placed(first), placed(second));
}

double RockMass::unbalanced_share() const {
    double force_n = 0.0, weight_n = 0.0;
    for (const Block& block : blocks_) {
        if (block.status == BlockStatus::moving || block.status == BlockStatus::asleep) {
            force_n += block.force_n.norm();
            weight_n += block.weight_n;
        }
    }
    return weight_n > 0.0 ? force_n / weight_n : 0.0;
}

Ledger RockMass::ledger() const {
    Ledger sums = taken_;
    for (const Block& block : blocks_) {
        sums.translation_j += block.translation_j();
        sums.rotation_j += block.rotation.energy_j(block.inertia_kgm2);
        if (block.status != BlockStatus::fixed && block.status != BlockStatus::handed) {
            sums.gravity_j += block.weight_n * (block.centre_m.z() - block.start_height_m);
        }
    }
    // Contacts take the time: energies side by side, sums in their order.
    std::vector<double> energies_j(joints_.size() + contacts_.size() + footings_.size(), 0.0);
    constexpr std::size_t chunk = 128;
    parallel_((energies_j.size() + chunk - 1) / chunk, [&](std::size_t part) {
        const std::size_t end = std::min(energies_j.size(), (part + 1) * chunk);
        for (std::size_t k = part * chunk; k < end; ++k) {
            if (k < joints_.size()) {
                const Joint& joint = joints_[k];
                energies_j[k] = joint.bond.intact
                                    ? 0.0
                                    : contact_energy_j(joint.bond.first, joint.bond.second, joint.state);
            } else if (k < joints_.size() + contacts_.size()) {
                const Contact& contact = contacts_[k - joints_.size()];
                energies_j[k] = contact_energy_j(contact.first, contact.second, contact.state);
            } else {
                energies_j[k] =
                    ground_energy_j(static_cast<std::uint32_t>(k - joints_.size() - contacts_.size()));
            }
        }
    });
    for (const double energy_j : energies_j) {
        sums.contact_normal_j += energy_j;
    }
    for (const Joint& joint : joints_) {
        if (joint.bond.intact) {
            const PlacedStrain placed_strain =
                strain_of(joint.bond, pose(joint.bond.first), pose(joint.bond.second));
            sums.bonds += bond_energy(joint.bond.section, joint.bond.stiffness, placed_strain.strain);
        }
        sums.contact_shear_j += joint.state.shear_energy_j();
    }
    for (const Contact& contact : contacts_) {
        sums.contact_shear_j += contact.state.shear_energy_j();
    }
    for (const Footing& footing : footings_) {
        sums.contact_shear_j += footing.state.shear_energy_j();
    }
    return sums;
}

}  // namespace rockfall::rock_mass
