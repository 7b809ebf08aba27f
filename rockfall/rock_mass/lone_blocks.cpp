#include "rockfall/rock_mass/lone_blocks.hpp"

#include "rockfall/rock_mass/rock_mass.hpp"

namespace rockfall::rock_mass {

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
        handed.push_back({i, block.centre_m, block.velocity_mps, block.rotation, footing.state.touching,
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

void RockMass::load_stem(std::size_t stem, double energy_j, bool breaks) {
    stems_[stem].taken_j += energy_j;
    stems_[stem].felled = stems_[stem].felled || breaks;
}

}  // namespace rockfall::rock_mass
