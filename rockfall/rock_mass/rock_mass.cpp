#include "rockfall/rock_mass/rock_mass.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace rockfall::rock_mass {

using Eigen::Matrix3d;
using Eigen::Vector3d;

BlockStart block_of(const solids::Hull& hull_in_space, double density_kgpm3, bool fixed) {
    BlockStart start;
    start.solid = solids::solid_of(hull_in_space, density_kgpm3);
    start.centre_m = start.solid.centroid_m;
    start.attitude = start.solid.from_given.conjugate();
    start.fixed = fixed;
    return start;
}

RockMass::RockMass(const Laws& laws, std::span<const BlockStart> blocks, std::span<const BondStart> bonds,
                   Ground ground, std::vector<StandingStem> stems, ParallelFor parallel)
    : laws_{laws}, parallel_{std::move(parallel)}, ground_{std::move(ground)}, stems_{std::move(stems)} {
    store_shapes(blocks);
    store_joints(bonds);
    set_step();
    footings_.resize(blocks_.size());
    margins_m_.assign(blocks_.size(), 0.0);
    ways_m_.assign(blocks_.size(), 0.0);
    for (const Block& block : blocks_) {
        motion_at_start_j_ += block.energy_j();
    }
    refresh();
    compute_forces();
    taken_ = {};
    taken_.start_j = ledger().held_j();
}

void RockMass::hold() {
    laws_when_let_go_ = laws_;
    laws_.friction = laws_.ground_friction = held_friction;
    laws_.local_damping = held_damping;
    laws_.damping_ratio = std::min(laws_.damping_ratio, most_held_damping_ratio);
    laws_.sleeping = false;
    blocks_when_let_go_ = blocks_;
    const std::vector<double> critical_s = critical_steps_s();
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        const double too_long = step_when_held_s_ / (held_step_factor() * critical_s[i]);
        if (too_long > 1.0) {
            blocks_[i].mass_kg *= too_long * too_long;
            blocks_[i].inertia_kgm2 *= too_long * too_long;
        }
    }
    std::swap(step_s_, step_when_held_s_);
    note_all();
}

void RockMass::let_go() {
    laws_ = *laws_when_let_go_;
    laws_when_let_go_.reset();
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        blocks_[i].velocity_mps.setZero();
        blocks_[i].rotation.momentum_nms.setZero();
        blocks_[i].still_s = blocks_[i].alone_s = 0.0;
        blocks_[i].start_height_m = blocks_[i].centre_m.z();
        blocks_[i].mass_kg = blocks_when_let_go_[i].mass_kg;
        blocks_[i].inertia_kgm2 = blocks_when_let_go_[i].inertia_kgm2;
        spins_[i].setZero();
    }
    blocks_when_let_go_.clear();
    std::swap(step_s_, step_when_held_s_);
    steps_ = 0;
    motion_at_start_j_ = 0.0;
    refresh();
    compute_forces();
    taken_ = {};
    broken_by_tension_ = broken_by_shear_ = 0;
    taken_.start_j = ledger().held_j();
}

void RockMass::store_shapes(std::span<const BlockStart> starts) {
    first_vertex_ = first_face_ = first_list_ = first_corner_ = {0};
    for (const BlockStart& start : starts) {
        const solids::Hull& hull = start.solid.hull;
        if (hull.faces.size() > most_faces) {
            throw std::invalid_argument{"a block has more faces than a rock mass takes"};
        }
        own_vertices_m_.insert(own_vertices_m_.end(), hull.vertices_m.begin(), hull.vertices_m.end());
        std::uint16_t corner = 0;
        for (const solids::Face& face : hull.faces) {
            if (face.corners.size() > most_corners) {
                throw std::invalid_argument{"a face has more corners than a rock mass takes"};
            }
            own_faces_.push_back({face.normal, face.offset_m});
            corner_lists_.push_back(corner);
            for (const std::uint32_t vertex : face.corners) {
                corners_.push_back(static_cast<std::uint16_t>(vertex));
            }
            corner = static_cast<std::uint16_t>(corner + face.corners.size());
        }
        corner_lists_.push_back(corner);
        first_vertex_.push_back(static_cast<std::uint32_t>(own_vertices_m_.size()));
        first_face_.push_back(static_cast<std::uint32_t>(own_faces_.size()));
        first_list_.push_back(static_cast<std::uint32_t>(corner_lists_.size()));
        first_corner_.push_back(static_cast<std::uint32_t>(corners_.size()));

        Block block;
        block.centre_m = start.centre_m;
        block.velocity_mps = start.fixed ? Vector3d{Vector3d::Zero()} : start.velocity_mps;
        block.rotation = {start.attitude, start.fixed ? Vector3d{Vector3d::Zero()} : start.momentum_nms};
        block.status = start.fixed ? BlockStatus::fixed : BlockStatus::moving;
        block.mass_kg = start.solid.mass_kg;
        block.weight_n = block.mass_kg * laws_.gravity_mps2;
        block.volume_m3 = start.solid.volume_m3;
        block.inertia_kgm2 = start.solid.inertia_kgm2;
        block.radius_m = start.solid.bounding_radius_m;
        block.half_side_m = 0.5 * std::cbrt(start.solid.volume_m3);
        block.start_height_m = start.centre_m.z();
        blocks_.push_back(block);
        spins_.push_back(block.spin_radps());
    }
    vertices_m_ = own_vertices_m_;
    faces_ = own_faces_;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        place(i);
    }
    note_all();
}

void RockMass::store_joints(std::span<const BondStart> bonds) {
    for (const BondStart& start : bonds) {
        const Block& first = blocks_[start.first];
        const Block& second = blocks_[start.second];
        const PlacedSection placed = section_of(start.polygon_m, start.normal);
        Joint joint;
        joint.bond.first = start.first;
        joint.bond.second = start.second;
        joint.bond.section = laws_.contact == ContactLaw::pfc && laws_.disc_areas
                                 ? disc_section(std::min(first.half_side_m, second.half_side_m))
                                 : placed.section;
        const double stiffness_npm3 = contact_pair(start.first, start.second).foundation_npm3;
        joint.bond.stiffness = {stiffness_npm3, stiffness_npm3 / laws_.stiffness_ratio};
        joint.bond.strength = start.strength;
        joint.bond.anchor_in_first_m =
            first.rotation.attitude.conjugate() * (placed.middle_m - first.centre_m);
        joint.bond.anchor_in_second_m =
            second.rotation.attitude.conjugate() * (placed.middle_m - second.centre_m);
        joint.bond.axes_in_first = first.rotation.attitude.conjugate() * placed.axes;
        joint.bond.axes_in_second = second.rotation.attitude.conjugate() * placed.axes;
        joint.bond.point_m = placed.middle_m;
        joints_.push_back(std::move(joint));
    }
}

void RockMass::place(std::size_t i) {
    const Block& block = blocks_[i];
    const Matrix3d turn = block.rotation.attitude.toRotationMatrix();
    for (std::uint32_t k = first_vertex_[i]; k < first_vertex_[i + 1]; ++k) {
        vertices_m_[k] = block.centre_m + turn * own_vertices_m_[k];
    }
    for (std::uint32_t k = first_face_[i]; k < first_face_[i + 1]; ++k) {
        faces_[k].normal = turn * own_faces_[k].normal;
        faces_[k].offset_m = own_faces_[k].offset_m + faces_[k].normal.dot(block.centre_m);
    }
}

PlacedBlock RockMass::placed(std::size_t i) const {
    const auto part = [](const auto& all, const std::vector<std::uint32_t>& first, std::size_t k) {
        return std::span{all}.subspan(first[k], first[k + 1] - first[k]);
    };
    return {part(vertices_m_, first_vertex_, i),
            part(faces_, first_face_, i),
            part(corner_lists_, first_list_, i),
            part(corners_, first_corner_, i),
            blocks_[i].centre_m,
            blocks_[i].radius_m};
}

void RockMass::add(const ChunkSums& sums) {
    taken_.friction_j += sums.losses.friction_j;
    taken_.dashpot_j += sums.losses.dashpot_j;
    taken_.fracture_j += sums.fracture_j;
    taken_.local_damping_j += sums.local_damping_j;
    taken_.rest_j += sums.rest_j;
    taken_.left_j += sums.left_j;
    broken_by_tension_ += sums.broken_by_tension;
    broken_by_shear_ += sums.broken_by_shear;
    steps_to_refresh_ = sums.strayed ? 0 : steps_to_refresh_;
    steps_to_list_ = sums.near_strayed ? 0 : steps_to_list_;
}

void RockMass::compute_forces() {
    KeptOverlap* const of_contacts = held_.data() + joints_.size();
    KeptOverlap* const of_ground = of_contacts + contacts_.size();
    in_chunks(joints_.size(), [&](std::size_t i, ChunkSums& sums) {
        fetch_joint_soon(i);
        force_of(joints_[i], held_[i], sums);
        load_ends_of_joint(i);
    });
    in_chunks(near_.size(), [&](std::size_t n, ChunkSums& sums) {
        fetch_soon(n);
        const std::size_t i = near_[n];
        Watch& watch = watches_[i];
        if (is_free(watch) || (stands(watch.first) && stands(watch.second))) {
            return;
        }
        const Eigen::Vector4d& first = places_m_[watch.first];
        const Eigen::Vector4d& second = places_m_[watch.second];
        watch.free_m = force_of(contacts_[i], of_contacts[i], sums);
        watch.turned_m = first[3] + second[3];
        watch.between_m = second.head<3>() - first.head<3>();
        const bool pressed = watch.presses;
        watch.presses = contacts_[i].state.touching;
        if (watch.presses || pressed) {
            load_ends_of_near(n);
        }
    });
    in_chunks(blocks_.size(), [&](std::size_t i, ChunkSums& sums) {
        force_of_ground(static_cast<std::uint32_t>(i), of_ground[i], sums);
        gather(i);
    });
}

void RockMass::step() {
    in_chunks(blocks_.size(), [&](std::size_t i, ChunkSums& sums) { move(i, sums); });
    ++steps_;
    if (steps_to_refresh_ == 0) {
        search_pairs();
    } else {
        --steps_to_refresh_;
        if (steps_to_list_ == 0) {
            list_near_contacts();
        } else {
            --steps_to_list_;
        }
    }
    compute_forces();
    in_chunks(blocks_.size(), [&](std::size_t i, ChunkSums& sums) { settle(i, sums); });
    meet_stems();
}

/// Half a step of velocity, with local damping as a force of its own.
void RockMass::kick(Block& block, ChunkSums& sums) const {
    const double half_s = 0.5 * step_s_;
    Vector3d force_n = block.force_n, moment_nm = block.moment_nm;
    if (laws_.local_damping > 0.0) {
        const Vector3d spin = block.spin_radps();
        const Vector3d damping_n =
            -laws_.local_damping * force_n.cwiseAbs().cwiseProduct(block.velocity_mps.cwiseSign());
        const Vector3d damping_nm =
            -laws_.local_damping * moment_nm.cwiseAbs().cwiseProduct(spin.cwiseSign());
        force_n += damping_n;
        moment_nm += damping_nm;
        const Vector3d after_mps = block.velocity_mps + half_s / block.mass_kg * force_n;
        solids::Rotation turned = block.rotation;
        turned.momentum_nms += half_s * (turned.attitude.conjugate() * moment_nm);
        const Vector3d spin_after = turned.spin_radps(block.inertia_kgm2);
        sums.local_damping_j -=
            0.5 * half_s *
            (damping_n.dot(block.velocity_mps + after_mps) + damping_nm.dot(spin + spin_after));
    }
    block.velocity_mps += half_s / block.mass_kg * force_n;
    block.rotation.momentum_nms += half_s * (block.rotation.attitude.conjugate() * moment_nm);
}

void RockMass::move(std::size_t i, ChunkSums& sums) {
    Block& block = blocks_[i];
    if (block.status != BlockStatus::moving) {
        return;
    }
    kick(block, sums);
    block.centre_m += step_s_ * block.velocity_mps;
    block.rotation = solids::rotate_free(block.rotation, block.inertia_kgm2, step_s_);
    spins_[i] = block.spin_radps();
    place(i);
    const double turned_m = step_s_ * spins_[i].norm() * block.radius_m;
    ways_m_[i] += step_s_ * block.velocity_mps.norm() + turned_m;
    places_m_[i] << block.centre_m, places_m_[i][3] + turned_m;
    sums.strayed = sums.strayed || ways_m_[i] > margins_m_[i];
    sums.near_strayed = sums.near_strayed || ways_m_[i] > near_ways_m_[i];
    note(i);
}

/// The second half of the step, and whether the block comes to rest or is woken.
void RockMass::settle(std::size_t i, ChunkSums& sums) {
    Block& block = blocks_[i];
    if (block.status == BlockStatus::asleep) {
        if (block.force_n.norm() > wake_share_of_weight * block.weight_n) {
            block.status = BlockStatus::moving;
            block.still_s = 0.0;
            note(i);
            sums.near_strayed = true;  // its neighbours may sleep: their pairs are looked at again
        }
        return;
    }
    if (block.status != BlockStatus::moving) {
        return;
    }
    kick(block, sums);
    spins_[i] = block.spin_radps();
    if (!ground_.empty() && footings_[i].prisms.empty()) {
        block.status = BlockStatus::left;
        sums.left_j += block.energy_j();
    } else if (laws_.sleeping) {
        const double speed_mps = block.velocity_mps.norm() + spins_[i].norm() * block.radius_m;
        block.still_s = speed_mps < sleep_speed_mps ? block.still_s + step_s_ : 0.0;
        if (block.still_s < sleep_after_s ||
            block.force_n.norm() > 0.5 * wake_share_of_weight * block.weight_n) {
            return;
        }
        block.status = BlockStatus::asleep;
        sums.rest_j += block.energy_j();
    } else {
        return;
    }
    block.velocity_mps.setZero();
    block.rotation.momentum_nms.setZero();
    spins_[i].setZero();
    note(i);
}

std::size_t RockMass::bonds_intact() const {
    return static_cast<std::size_t>(
        std::count_if(joints_.begin(), joints_.end(), [](const Joint& joint) { return joint.bond.intact; }));
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> RockMass::intact_bonds() const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const Joint& joint : joints_) {
        if (joint.bond.intact) {
            pairs.emplace_back(joint.bond.first, joint.bond.second);
        }
    }
    return pairs;
}

std::size_t RockMass::bytes() const {
    constexpr std::size_t list_of_prisms = 16 * sizeof(std::uint32_t);
    return blocks_.size() * (sizeof(Block) + sizeof(Footing) + list_of_prisms + 3 * sizeof(Vector3d)) +
           (vertices_m_.size() * sizeof(Vector3d) + faces_.size() * sizeof(Plane3)) * 2 +
           joints_.size() * (sizeof(Joint) + 6 * sizeof(Eigen::Vector2d)) +
           contacts_.size() * (sizeof(Contact) + sizeof(Watch)) + held_.size() * sizeof(KeptOverlap) +
           static_cast<std::size_t>(std::count_if(held_.begin(), held_.end(),
                                                  [](const KeptOverlap& held) { return held != nullptr; })) *
               sizeof(HeldOverlap) +
           ends_.size() * sizeof(EndLoad) + near_.size() * 3 * sizeof(std::uint32_t) +
           ground_.prisms().size() * (sizeof(GroundPrism) + 16);
}

}  // namespace rockfall::rock_mass
