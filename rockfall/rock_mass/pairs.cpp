// Which blocks of a rock mass may touch, and its state as numbers.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>

#include "rockfall/rock_mass/rock_mass.hpp"

namespace rockfall::rock_mass {

using Eigen::Vector3d;

namespace {

/// Steps after which pairs are searched again at the latest: so many that blocks go a fifth of their size,
/// by half of their side [choice].
constexpr double way_by_half_side = 0.2;
constexpr std::uint32_t least_steps_between = 24, most_steps_between = 48;

std::uint32_t steps_between(std::span<const Block> blocks, double step_s) {
    double ways_m = 0.0, sides_m = 0.0;
    for (const Block& block : blocks) {
        if (block.status == BlockStatus::moving) {
            ways_m += step_s * block.velocity_mps.norm();
            sides_m += block.half_side_m;
        }
    }
    if (!(ways_m > 0.0)) {
        return most_steps_between;
    }
    const double steps = way_by_half_side * sides_m / ways_m;
    return static_cast<std::uint32_t>(
        std::clamp(steps, static_cast<double>(least_steps_between), static_cast<double>(most_steps_between)));
}

Box3 box_around(std::span<const Vector3d> points_m, double margin_m) {
    Box3 box{points_m[0], points_m[0]};
    for (const Vector3d& point_m : points_m) {
        box.low_m = box.low_m.cwiseMin(point_m);
        box.high_m = box.high_m.cwiseMax(point_m);
    }
    box.low_m.array() -= margin_m;
    box.high_m.array() += margin_m;
    return box;
}

bool stem_is_near(const StandingStem& stem, const Box3& box) {
    return stem.x_m > box.low_m.x() - stem.radius_m && stem.x_m < box.high_m.x() + stem.radius_m &&
           stem.y_m > box.low_m.y() - stem.radius_m && stem.y_m < box.high_m.y() + stem.radius_m &&
           stem.ground_m < box.high_m.z() && stem.top_m > box.low_m.z();
}

/// Writes and reads the numbers of a state in one order.
class Packer {
public:
    explicit Packer(std::vector<double>& out) : out_{out} {}
    void operator()(double value) { out_.push_back(value); }
    void operator()(const Vector3d& v) { out_.insert(out_.end(), {v.x(), v.y(), v.z()}); }
    void operator()(const Eigen::Quaterniond& q) { out_.insert(out_.end(), {q.w(), q.x(), q.y(), q.z()}); }

private:
    std::vector<double>& out_;
};

class Unpacker {
public:
    explicit Unpacker(std::span<const double> in) : in_{in} {}
    void operator()(double& value) { value = next(); }
    void operator()(Vector3d& v) {
        for (int k = 0; k < 3; ++k) {
            v[k] = next();
        }
    }
    void operator()(Eigen::Quaterniond& q) {
        q.w() = next();
        q.x() = next();
        q.y() = next();
        q.z() = next();
    }
    double next() {
        if (at_ >= in_.size()) {
            whole_ = false;
            return 0.0;
        }
        return in_[at_++];
    }
    [[nodiscard]] bool is_whole() const { return whole_; }
    [[nodiscard]] bool is_at_end() const { return whole_ && at_ == in_.size(); }

private:
    std::span<const double> in_;
    std::size_t at_ = 0;
    bool whole_ = true;
};

template <class Visit, class State>
void visit_state(Visit& visit, State& state) {
    visit(state.normal);
    visit(state.shear_n);
    visit(state.dashpot_n);
    visit(state.dashpot_nspm);
    visit(state.tilt_dashpot_nm);
    visit(state.point_m);
    visit(state.anchor_m);
    visit(state.shear_dashpot_n);
    visit(state.shear_stiffness_npm);
    visit(state.torsion_nm);
    visit(state.torsion_dashpot_nm);
    visit(state.torsion_stiffness_nm);
    visit(state.normal_energy_j);
}

template <class Visit, class Force>
void visit_force(Visit& visit, Force& force) {
    visit(force.force_n);
    visit(force.moment_on_first_nm);
    visit(force.moment_on_second_nm);
}

template <class Visit, class Sums>
void visit_ledger(Visit& visit, Sums& sums) {
    visit(sums.friction_j);
    visit(sums.dashpot_j);
    visit(sums.local_damping_j);
    visit(sums.fracture_j);
    visit(sums.trees_j);
    visit(sums.rest_j);
    visit(sums.left_j);
    visit(sums.handed_motion_j);
    visit(sums.handed_gravity_j);
    visit(sums.handed_strain_j);
    visit(sums.back_motion_j);
    visit(sums.back_gravity_j);
    visit(sums.back_strain_j);
    visit(sums.start_j);
}

template <class Visit, class AnyBlock>
void visit_block(Visit& visit, AnyBlock& block) {
    visit(block.centre_m);
    visit(block.velocity_mps);
    visit(block.rotation.attitude);
    visit(block.rotation.momentum_nms);
    visit(block.still_s);
    visit(block.alone_s);
    visit(block.start_height_m);
    visit(block.force_n);
    visit(block.moment_nm);
    visit(block.dashpots_ps);
}

}  // namespace

void RockMass::refresh() {
    note_all();
    held_.clear();
    held_.resize(joints_.size() + contacts_.size() + footings_.size());
    watches_.assign(contacts_.size(), {});
    places_m_.resize(blocks_.size());
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        places_m_[i] << blocks_[i].centre_m, 0.0;
    }
    for (Footing& footing : footings_) {
        footing.free_way_m = 0.0;
    }
    for (Joint& joint : joints_) {
        joint.state.known.axis.setZero();
    }
    for (Contact& contact : contacts_) {
        contact.state.known.axis.setZero();
    }
    search_pairs();
}

void RockMass::search_pairs() {
    const std::uint32_t steps = steps_between(blocks_, step_s_);
    const double interval_s = steps * step_s_;
    std::vector<Box3> boxes(blocks_.size());
    std::vector<std::uint8_t> moves(blocks_.size(), 0);
    in_chunks(blocks_.size(), [&](std::size_t i, ChunkSums&) {
        const Block& block = blocks_[i];
        const double speed_mps = block.velocity_mps.norm() + spins_[i].norm() * block.radius_m;
        margins_m_[i] = 1.25 * speed_mps * interval_s + 0.5 * laws_.gravity_mps2 * interval_s * interval_s +
                        0.03 * block.half_side_m;
        moves[i] = block.status == BlockStatus::fixed ? 0 : 1;
        boxes[i] = box_around(placed(i).vertices_m, margins_m_[i]);
        Footing& footing = footings_[i];
        footing.free_way_m -= ways_m_[i];
        ways_m_[i] = 0.0;
        if (block.status == BlockStatus::left || block.status == BlockStatus::handed) {
            boxes[i].low_m.x() = std::numeric_limits<double>::infinity();
        } else if (block.status == BlockStatus::moving) {
            footing.prisms = ground_.prisms_in(boxes[i].low_m.head<2>(), boxes[i].high_m.head<2>());
            footing.highest_ground_m = ground_.highest_m(footing.prisms);
        }
    });

    // Broken joints go on as contacts.
    const std::vector<Contact> known = std::move(contacts_);
    const std::vector<Watch> known_watches = std::move(watches_);
    std::vector<KeptOverlap> known_held = std::move(held_);
    const std::size_t first_known = joints_.size();
    std::vector<Contact> broken;
    for (const Joint& joint : joints_) {
        if (!joint.bond.intact) {
            broken.push_back({joint.bond.first, joint.bond.second, joint.state, joint.force});
            if (joint.bond.first > joint.bond.second) {
                broken.back().first = joint.bond.second;
                broken.back().second = joint.bond.first;
                broken.back().state = reversed(joint.state);
                broken.back().force = {-joint.force.force_n, joint.force.moment_on_second_nm,
                                       joint.force.moment_on_first_nm};
            }
        }
    }
    std::erase_if(joints_, [](const Joint& joint) { return !joint.bond.intact; });
    const auto blocks_of = [](const Contact& contact) { return std::pair{contact.first, contact.second}; };
    std::sort(broken.begin(), broken.end(),
              [&](const Contact& a, const Contact& b) { return blocks_of(a) < blocks_of(b); });
    std::vector<std::pair<std::uint32_t, std::uint32_t>> joined;
    for (const Joint& joint : joints_) {
        joined.emplace_back(std::min(joint.bond.first, joint.bond.second),
                            std::max(joint.bond.first, joint.bond.second));
    }
    std::sort(joined.begin(), joined.end());

    contacts_.clear();
    watches_.clear();
    held_.clear();
    held_.resize(joints_.size());
    auto old = known.begin();
    auto freed = broken.begin();
    auto bond = joined.begin();
    for (const auto& pair : meeting_pairs(boxes, moves)) {
        while (bond != joined.end() && *bond < pair) {
            ++bond;
        }
        if (bond != joined.end() && *bond == pair) {
            continue;
        }
        while (old != known.end() && blocks_of(*old) < pair) {
            ++old;
        }
        while (freed != broken.end() && blocks_of(*freed) < pair) {
            ++freed;
        }
        held_.emplace_back();
        watches_.push_back({pair.first, pair.second});
        if (old != known.end() && blocks_of(*old) == pair) {
            const auto number = static_cast<std::size_t>(old - known.begin());
            contacts_.push_back(*old);
            if (known_watches[number].free_m > 0.0) {
                watches_.back() = known_watches[number];
            }
            if (old->state.touching) {
                held_.back() = std::move(known_held[first_known + number]);
            }
        } else if (freed != broken.end() && blocks_of(*freed) == pair) {
            contacts_.push_back(*freed);
        } else {
            contacts_.push_back({pair.first, pair.second, {}, {}});
        }
    }
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
        watches_[k].presses = contacts_[k].state.touching;
    }
    held_.insert(held_.end(), std::make_move_iterator(known_held.end() - std::ssize(footings_)),
                 std::make_move_iterator(known_held.end()));
    list_near_contacts();
    find_stems(boxes);
    steps_to_refresh_ = steps;
}

void RockMass::find_stems(std::span<const Box3> boxes) {
    near_stems_.clear();
    if (stems_.empty()) {
        return;
    }
    std::vector<std::pair<double, std::uint32_t>> from_west;
    double widest_m = 0.0;
    for (std::uint32_t k = 0; k < stems_.size(); ++k) {
        if (!stems_[k].is_broken()) {
            from_west.emplace_back(stems_[k].x_m, k);
            widest_m = std::max(widest_m, stems_[k].radius_m);
        }
    }
    std::sort(from_west.begin(), from_west.end());
    for (std::uint32_t i = 0; i < blocks_.size(); ++i) {
        if (blocks_[i].status != BlockStatus::moving) {
            continue;
        }
        auto stem = std::lower_bound(from_west.begin(), from_west.end(),
                                     std::pair{boxes[i].low_m.x() - widest_m, std::uint32_t{0}});
        for (; stem != from_west.end() && stem->first < boxes[i].high_m.x() + widest_m; ++stem) {
            if (stem_is_near(stems_[stem->second], boxes[i])) {
                near_stems_.emplace_back(i, stem->second);
            }
        }
    }
}

std::vector<double> RockMass::packed() const {
    std::vector<double> numbers;
    Packer pack{numbers};
    pack(static_cast<double>(steps_));
    pack(static_cast<double>(broken_by_tension_));
    pack(static_cast<double>(broken_by_shear_));
    visit_ledger(pack, taken_);
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        visit_block(pack, blocks_[i]);
        pack(static_cast<double>(blocks_[i].status));
        visit_state(pack, footings_[i].state);
        pack(footings_[i].state.touching ? 1.0 : 0.0);
        visit_force(pack, footings_[i].force);
        pack(static_cast<double>(footings_[i].prisms.size()));
        for (const std::uint32_t prism : footings_[i].prisms) {
            pack(static_cast<double>(prism));
        }
    }
    for (const StandingStem& stem : stems_) {
        pack(stem.taken_j);
        pack(stem.felled ? 1.0 : 0.0);
    }
    pack(static_cast<double>(joints_.size()));
    for (const Joint& joint : joints_) {
        pack(static_cast<double>(joint.bond.first));
        pack(static_cast<double>(joint.bond.second));
        pack(joint.bond.dashpot_n);
        pack(joint.bond.point_m);
        visit_force(pack, joint.force);
    }
    pack(static_cast<double>(contacts_.size()));
    for (const Contact& contact : contacts_) {
        pack(static_cast<double>(contact.first));
        pack(static_cast<double>(contact.second));
        visit_state(pack, contact.state);
        pack(contact.state.touching ? 1.0 : 0.0);
        pack(static_cast<double>(contact.state.known.face));
        pack(static_cast<double>(contact.state.known.other_face));
        pack(contact.state.known.of_second ? 1.0 : 0.0);
        visit_force(pack, contact.force);
    }
    return numbers;
}

bool RockMass::unpack(std::span<const double> numbers) {
    Unpacker unpack{numbers};
    steps_ = static_cast<std::uint64_t>(unpack.next());
    broken_by_tension_ = static_cast<std::uint64_t>(unpack.next());
    broken_by_shear_ = static_cast<std::uint64_t>(unpack.next());
    visit_ledger(unpack, taken_);
    for (std::size_t i = 0; i < blocks_.size() && unpack.is_whole(); ++i) {
        visit_block(unpack, blocks_[i]);
        blocks_[i].status = static_cast<BlockStatus>(static_cast<int>(unpack.next()));
        spins_[i] = blocks_[i].spin_radps();
        place(i);
        visit_state(unpack, footings_[i].state);
        footings_[i].state.touching = unpack.next() != 0.0;
        visit_force(unpack, footings_[i].force);
        footings_[i].prisms.clear();
        for (auto count = static_cast<std::size_t>(unpack.next()); count > 0 && unpack.is_whole(); --count) {
            footings_[i].prisms.push_back(static_cast<std::uint32_t>(unpack.next()));
        }
        footings_[i].highest_ground_m = ground_.highest_m(footings_[i].prisms);
    }
    for (StandingStem& stem : stems_) {
        unpack(stem.taken_j);
        stem.felled = unpack.next() != 0.0;
    }
    std::vector<Joint> left;
    auto joint = joints_.begin();
    for (auto count = static_cast<std::size_t>(unpack.next()); count > 0 && unpack.is_whole(); --count) {
        const auto first = static_cast<std::uint32_t>(unpack.next());
        const auto second = static_cast<std::uint32_t>(unpack.next());
        while (joint != joints_.end() && (joint->bond.first != first || joint->bond.second != second)) {
            ++joint;
        }
        if (joint == joints_.end()) {
            return false;
        }
        unpack(joint->bond.dashpot_n);
        unpack(joint->bond.point_m);
        visit_force(unpack, joint->force);
        left.push_back(std::move(*joint++));
    }
    joints_ = std::move(left);
    contacts_.clear();
    for (auto count = static_cast<std::size_t>(unpack.next()); count > 0 && unpack.is_whole(); --count) {
        Contact contact;
        contact.first = static_cast<std::uint32_t>(unpack.next());
        contact.second = static_cast<std::uint32_t>(unpack.next());
        visit_state(unpack, contact.state);
        contact.state.touching = unpack.next() != 0.0;
        contact.state.known.face = static_cast<std::uint16_t>(unpack.next());
        contact.state.known.other_face = static_cast<std::uint16_t>(unpack.next());
        contact.state.known.of_second = unpack.next() != 0.0;
        visit_force(unpack, contact.force);
        contacts_.push_back(contact);
    }
    if (!unpack.is_at_end()) {
        return false;
    }
    refresh();
    return true;
}

}  // namespace rockfall::rock_mass
