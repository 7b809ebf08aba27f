#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "coupling/assessments/collapse/collapse_site.hpp"
#include "coupling/assessments/collapse/handed_fall.hpp"
#include "rockfall/rock_mass/rock_mass.hpp"

namespace coupling::collapse {

/// A free block as maps, targets and pictures see it, whichever model moves it.
struct SeenBlock {
    Eigen::Vector3d centre_m;
    Eigen::Quaterniond attitude;
    Eigen::Vector3d velocity_mps;
    double translation_j = 0.0;
    double energy_j = 0.0;
    rockfall::rock_mass::BlockStatus status;  ///< never `handed`: moving, asleep (rests) or left
    bool is_handed = false;
};

/// Single blocks that left the mass and go on alone (rockfall/motion/block_fall.hpp).
///
/// A block is handed over at a look, once it has been alone for long enough, moves, and lies over terrain
/// that was not dug out. Its whole way is computed at once: it meets ground, trees and targets, no other
/// block. What it does to trees counts for the mass from the time on at which it happens.
class HandOver {
public:
    HandOver() = default;  ///< hands nothing over
    HandOver(const CollapseScenario& scenario, const CollapseSite& site, double look_s,
             rockfall::rock_mass::ParallelFor parallel);

    /// After the steps of a look: trees that were hit since, and blocks that leave the mass now.
    void look(rockfall::rock_mass::RockMass& mass);

    [[nodiscard]] std::span<const HandedFall> falls() const { return falls_; }
    /// When a fall began.
    [[nodiscard]] double start_s(std::size_t fall) const { return starts_s_[fall]; }
    /// The fall of a block; nullptr: it is part of the mass.
    [[nodiscard]] const HandedFall* fall_of(std::size_t block) const {
        return block < fall_of_.size() && fall_of_[block] >= 0
                   ? &falls_[static_cast<std::size_t>(fall_of_[block])]
                   : nullptr;
    }
    /// When a block that was handed over left the mass.
    [[nodiscard]] double handed_at_s(std::size_t block) const {
        return starts_s_[static_cast<std::size_t>(fall_of_[block])];
    }
    [[nodiscard]] SeenBlock seen(const rockfall::rock_mass::RockMass& mass, std::size_t block) const;
    /// Whether no handed block moves any more.
    [[nodiscard]] bool is_over(double time_s) const;
    /// Energy that handed blocks gave to a stem up to a time.
    [[nodiscard]] double given_to_stem_j(std::size_t stem, double time_s) const;

    /// What each block left with, as numbers. `unpack` follows the falls again: requires the mass as it was
    /// then, and returns false for numbers that cannot be those.
    [[nodiscard]] std::vector<double> packed() const;
    bool unpack(std::span<const double> numbers, const rockfall::rock_mass::RockMass& mass);

private:
    struct Crossing {
        rockfall::rock_mass::HandedBlock block;
        std::vector<std::uint32_t> gone;  ///< stems that did not stand any more
    };
    void follow_from(std::size_t first_fall);

    const CollapseSite* site_ = nullptr;
    FallSettings settings_;
    double after_s_ = 0.0;
    rockfall::rock_mass::ParallelFor parallel_;
    std::vector<Crossing> crossings_;
    std::vector<double> starts_s_;
    std::vector<HandedFall> falls_;
    std::vector<std::size_t> blows_done_;
    std::vector<std::int32_t> fall_of_;  ///< by block; -1: none
};

}  // namespace coupling::collapse
