#include "rockfall/rock_mass/lone_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rockfall/rock_mass/rock_mass.hpp"

namespace rockfall::rock_mass {

using Eigen::Vector3d;

/// Without intact bond, and without contact with another block.
bool RockMass::is_alone(std::size_t i) const {
    for (std::uint32_t k = first_end_[i]; k < first_end_[i + 1]; ++k) {
        if (ends_[k].holds) {
            return false;
        }
    }
    return true;
}

double RockMass::ground_energy_j(std::uint32_t i) const {
    const Footing& footing = footings_[i];
    if (!footing.state.touching) {
        return 0.0;
    }
    return laws_.contact == ContactLaw::pfc
               ? footing.state.normal_energy_j
               : ground_pair(i).foundation_npm3 * ground_.energy_m4(footing.prisms, placed(i));
}

std::vector<std::uint32_t> RockMass::lone_blocks(double longer_than_s) const {
    std::vector<std::uint32_t> lone;
    for (std::uint32_t i = 0; i < blocks_.size(); ++i) {
        const Block& block = blocks_[i];
        if (block.status == BlockStatus::moving && block.alone_s > longer_than_s &&
            block.velocity_mps.norm() > lone_speed_mps &&
            ground_energy_j(i) + footings_[i].state.shear_energy_j() <=
                lone_strain_share * block.energy_j()) {
            lone.push_back(i);
        }
    }
    return lone;
}

std::vector<HandedBlock> RockMass::hand_over(std::span<const std::uint32_t> numbers) {
    std::vector<HandedBlock> handed;
    for (const std::uint32_t i : numbers) {
        Block& block = blocks_[i];
        Footing& footing = footings_[i];
        const solids::Rotation own{block.rotation.attitude, block.rotation.momentum_nms / block.mass_factor};
        handed.push_back({i, block.centre_m, block.velocity_mps, own, footing.state.touching,
                          block.own_energy_j(), block.weight_n * (block.centre_m.z() - block.start_height_m),
                          ground_energy_j(i) + footing.state.shear_energy_j() +
                              (block.energy_j() - block.own_energy_j())});
        taken_.handed_motion_j += handed.back().motion_j;
        taken_.handed_gravity_j += handed.back().gravity_j;
        taken_.handed_strain_j += handed.back().strain_j;
        block.status = BlockStatus::handed;
        block.velocity_mps.setZero();
        block.rotation.momentum_nms.setZero();
        block.force_n.setZero();
        block.moment_nm.setZero();
        spins_[i].setZero();
        footing.state = {};
        footing.force = {};
        footing.prisms.clear();
    }
    if (!handed.empty()) {
        refresh();  // no pair has one of them any more
    }
    return handed;
}

/// Moves a block upwards until nothing of it lies in the ground, and returns how far.
double RockMass::lift_out_of_ground(std::uint32_t i) {
    Block& block = blocks_[i];
    const Vector3d lay_m = block.centre_m;
    const Eigen::Vector2d reach_m = Eigen::Vector2d::Constant(block.radius_m);
    const std::vector<std::uint32_t> prisms =
        ground_.prisms_in(lay_m.head<2>() - reach_m, lay_m.head<2>() + reach_m);
    const auto is_clear = [&](double lift_m) {
        block.centre_m = lay_m + lift_m * Vector3d::UnitZ();
        place(i);
        return ground_.overlap_of(prisms, placed(i), block.centre_m).is_none();
    };
    if (is_clear(0.0)) {
        return 0.0;
    }
    double low_m = 0.0, high_m = 1e-3 * block.half_side_m;
    while (!is_clear(high_m)) {
        low_m = std::exchange(high_m, 2.0 * high_m);
    }
    for (const double least_m = 1e-6 * block.half_side_m; high_m - low_m > least_m;) {
        const double middle_m = 0.5 * (low_m + high_m);
        (is_clear(middle_m) ? high_m : low_m) = middle_m;
    }
    is_clear(high_m);
    return high_m;
}

std::vector<TakenBack> RockMass::take_back(std::span<const BlockBack> backs) {
    std::vector<TakenBack> taken;
    std::vector<std::int32_t> taken_of(blocks_.size(), -1);
    for (const BlockBack& back : backs) {
        const std::uint32_t i = back.number;
        Block& block = blocks_[i];
        block.status = BlockStatus::moving;
        block.centre_m = back.centre_m;
        block.velocity_mps = back.velocity_mps;
        block.rotation = {back.rotation.attitude, block.mass_factor * back.rotation.momentum_nms};
        block.still_s = block.alone_s = 0.0;
        const double lift_m = lift_out_of_ground(i);
        place(i);
        if (const double motion_j = block.energy_j(); lift_m > 0.0 && motion_j > 0.0) {
            const double left = std::sqrt(std::max(0.0, 1.0 - block.weight_n * lift_m / motion_j));
            block.velocity_mps *= left;
            block.rotation.momentum_nms *= left;
        }
        block.force_n = {0.0, 0.0, -block.weight_n};
        block.moment_nm.setZero();
        block.dashpots_ps = 0.0;
        spins_[i] = block.spin_radps();
        taken_of[i] = static_cast<std::int32_t>(taken.size());
        taken.push_back({block.own_energy_j(), lift_m, 0.0});
        taken_.back_motion_j += block.own_energy_j();
        taken_.back_gravity_j += block.weight_n * (block.centre_m.z() - block.start_height_m);
        taken_.back_strain_j += block.energy_j() - block.own_energy_j();
    }
    if (taken.empty()) {
        return taken;
    }
    refresh();
    // Contacts begin with the next step; what they will hold then is there now.
    for (const Contact& contact : contacts_) {
        const std::int32_t number = std::max(taken_of[contact.first], taken_of[contact.second]);
        if (number >= 0 && laws_.contact != ContactLaw::pfc) {
            const double strain_j = contact_pair(contact.first, contact.second).foundation_npm3 *
                                    overlap_energy_m4(placed(contact.first), placed(contact.second));
            taken[static_cast<std::size_t>(number)].strain_j += strain_j;
            taken_.back_strain_j += strain_j;
        }
    }
    return taken;
}

void RockMass::load_stem(std::size_t stem, double energy_j, bool breaks) {
    stems_[stem].taken_j += energy_j;
    stems_[stem].felled = stems_[stem].felled || breaks;
}

}  // namespace rockfall::rock_mass
