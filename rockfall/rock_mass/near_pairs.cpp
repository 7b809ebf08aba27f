// Of all pairs of a rock mass, those that a step has to look at, and what it reads of their blocks.

#include "rockfall/rock_mass/rock_mass.hpp"

namespace rockfall::rock_mass {

using Eigen::Vector3d;

namespace {

/// Steps after which near contacts are listed again at the latest.
constexpr std::uint32_t steps_between_lists = 8;

/// Asks for what a contact will need, while others are computed.
void fetch(const void* from, std::size_t bytes) {
#if defined(__GNUC__)
    const char* const at = static_cast<const char*>(from);
    for (std::size_t k = 0; k < bytes; k += 64) {
        __builtin_prefetch(at + k);
    }
#endif
}

}  // namespace

/// Copies what pairs look at from a block.
void RockMass::note(std::size_t i) {
    const Block& block = blocks_[i];
    moved_[i] = {block.centre_m, block.velocity_mps, spins_[i], block.rotation.attitude, block.status};
}

void RockMass::note_all() {
    moved_.resize(blocks_.size());
    sides_.resize(blocks_.size());
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        note(i);
        const Block& block = blocks_[i];
        sides_[i] = {block.status == BlockStatus::fixed ? 0.0 : 1.0 / block.mass_kg,
                     block.inertia_kgm2.cwiseInverse(),
                     block.half_side_m,
                     block.radius_m,
                     block.weight_n,
                     block.dashpots_ps};
    }
}

double RockMass::free_left_m(const Watch& watch) const {
    const Eigen::Vector4d& first = places_m_[watch.first];
    const Eigen::Vector4d& second = places_m_[watch.second];
    const double moved_m = (second.head<3>() - first.head<3>() - watch.between_m).norm();
    return watch.free_m - (first[3] + second[3] - watch.turned_m) - moved_m;
}

/// Contacts are listed again before a block has gone farther than it may, or when one wakes.
void RockMass::list_near_contacts() {
    const double interval_s = steps_between_lists * step_s_;
    near_ways_m_.resize(blocks_.size());
    std::vector<double> reaches_m(blocks_.size(), 0.0);
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        const Block& block = blocks_[i];
        if (block.status == BlockStatus::moving) {
            const double speed_mps = block.velocity_mps.norm() + spins_[i].norm() * block.radius_m;
            reaches_m[i] = 1.25 * speed_mps * interval_s +
                           0.5 * laws_.gravity_mps2 * interval_s * interval_s + 0.06 * block.half_side_m;
        }
        near_ways_m_[i] = ways_m_[i] + reaches_m[i];
    }
    std::vector<std::uint8_t> may_meet(contacts_.size());
    in_chunks(contacts_.size(), [&](std::size_t k, ChunkSums&) {
        const Watch& watch = watches_[k];
        may_meet[k] = stands(watch.first) && stands(watch.second)
                          ? watch.presses
                          : free_left_m(watch) <= reaches_m[watch.first] + reaches_m[watch.second];
    });
    near_.clear();
    for (std::uint32_t k = 0; k < contacts_.size(); ++k) {
        if (may_meet[k] != 0) {
            near_.push_back(k);
        }
    }
    list_ends();
    steps_to_list_ = steps_between_lists;
}

void RockMass::list_ends() {
    ends_of_.resize(joints_.size() + near_.size());
    first_end_.assign(blocks_.size() + 1, 0);
    const auto each_end = [&](const auto& visit) {
        for (std::size_t k = 0; k < joints_.size(); ++k) {
            visit(joints_[k].bond.first, ends_of_[k][0]);
            visit(joints_[k].bond.second, ends_of_[k][1]);
        }
        for (std::size_t k = 0; k < near_.size(); ++k) {
            visit(watches_[near_[k]].first, ends_of_[joints_.size() + k][0]);
            visit(watches_[near_[k]].second, ends_of_[joints_.size() + k][1]);
        }
    };
    each_end([&](std::uint32_t block, std::uint32_t&) { ++first_end_[block + 1]; });
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        first_end_[i + 1] += first_end_[i];
    }
    std::vector<std::uint32_t> next(first_end_.begin(), first_end_.end() - 1);
    each_end([&](std::uint32_t block, std::uint32_t& end) { end = next[block]++; });
    ends_.assign(first_end_.back(), {});
    in_chunks(joints_.size(), [&](std::size_t k, ChunkSums&) { load_ends_of_joint(k); });
    in_chunks(near_.size(), [&](std::size_t k, ChunkSums&) {
        if (watches_[near_[k]].presses) {
            load_ends_of_near(k);
        }
    });
}

/// Rate at which the dashpots of a contact would take the motion of one of its blocks.
double RockMass::dashpot_rate_ps(std::uint32_t block, const ContactState& state) const {
    if (!state.touching) {
        return 0.0;
    }
    const Moved& moved = moved_[block];
    const PairSide& side = sides_[block];
    const Vector3d arm_m =
        moved.attitude.conjugate() * Vector3d{(state.point_m - moved.centre_m).cross(state.normal)};
    return state.dashpot_nspm * (side.inverse_mass_pkg + arm_m.cwiseAbs2().dot(side.inverse_inertia));
}

void RockMass::load_ends(std::size_t pair, std::uint32_t first, std::uint32_t second,
                         const ContactState& state, const PairForce& force, bool holds) {
    ends_[ends_of_[pair][0]] = {-force.force_n, force.moment_on_first_nm, dashpot_rate_ps(first, state),
                                holds};
    ends_[ends_of_[pair][1]] = {force.force_n, force.moment_on_second_nm, dashpot_rate_ps(second, state),
                                holds};
}

void RockMass::load_ends_of_joint(std::size_t joint) {
    const Joint& of = joints_[joint];
    load_ends(joint, of.bond.first, of.bond.second, of.state, of.force, of.bond.intact || of.state.touching);
}

void RockMass::load_ends_of_near(std::size_t near) {
    const Contact& of = contacts_[near_[near]];
    load_ends(joints_.size() + near, of.first, of.second, of.state, of.force, of.state.touching);
}

void RockMass::fetch_joint_soon(std::size_t joint) const {
    constexpr std::size_t later = 6, soon = 3;
    if (joint + later < joints_.size()) {
        fetch(&joints_[joint + later], sizeof(Joint));
    }
    if (joint + soon < joints_.size()) {
        const Bond& bond = joints_[joint + soon].bond;
        fetch(bond.section.corners_m.data(), bond.section.corners_m.size() * sizeof(Eigen::Vector2d));
        fetch(&moved_[bond.first], sizeof(Moved));
        fetch(&moved_[bond.second], sizeof(Moved));
        fetch(&sides_[bond.first], sizeof(PairSide));
        fetch(&sides_[bond.second], sizeof(PairSide));
        for (const std::uint32_t end : ends_of_[joint + soon]) {
            fetch(&ends_[end], sizeof(EndLoad));
        }
    }
}

/// A step is mostly waiting for memory.
void RockMass::fetch_soon(std::size_t near) const {
    constexpr std::size_t later = 8, soon = 4;
    if (near + later < near_.size()) {
        const std::uint32_t k = near_[near + later];
        if (watches_[k].presses) {
            fetch(&contacts_[k], sizeof(Contact));
            fetch(&held_[joints_.size() + k], sizeof(KeptOverlap));
        }
    }
    if (near + soon < near_.size()) {
        const std::uint32_t k = near_[near + soon];
        if (watches_[k].presses) {
            for (const std::uint32_t block : {watches_[k].first, watches_[k].second}) {
                fetch(&moved_[block], sizeof(Moved));
                fetch(&sides_[block], sizeof(PairSide));
            }
            if (const HeldOverlap* const held = held_[joints_.size() + k].get(); held != nullptr) {
                fetch(held, sizeof(HeldOverlap));
            }
            for (const std::uint32_t end : ends_of_[joints_.size() + near + soon]) {
                fetch(&ends_[end], sizeof(EndLoad));
            }
        }
    }
}

}  // namespace rockfall::rock_mass
