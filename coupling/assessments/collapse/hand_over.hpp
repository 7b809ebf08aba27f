#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "coupling/assessments/collapse/collapse_site.hpp"
#include "coupling/assessments/collapse/handed_fall.hpp"
#include "coupling/assessments/collapse/meeting_blocks.hpp"
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

/// A look has about so many guards: times at which single blocks come back into the mass [choice].
inline constexpr std::uint64_t guards_of_look = 5;

/// The steps of a look in equal guards.
struct GuardPlan {
    std::uint64_t guards = guards_of_look;
    std::uint64_t steps_of_guard = 1;
    [[nodiscard]] std::uint64_t steps() const { return guards * steps_of_guard; }
};
/// For a look of about so many steps: fewer guards where it has fewer steps. Looks of up to eight steps keep
/// their length, others change it by a ninth at most.
GuardPlan guards_for(std::uint64_t steps_of_look);

/// A block that came back.
struct Return {
    double time_s = 0.0;
    rockfall::rock_mass::TakenBack taken;
};

/// Single blocks that left the mass and go on alone (rockfall/motion/block_fall.hpp).
///
/// A block is handed over at a look, once it has been alone for long enough, moves, lies over terrain that
/// was not dug out, and meets no other block before the next look as all move now. Its whole way is computed
/// at once, with ground, trees and targets, as if it met no other block. Where one could touch it before the
/// next guard, whether it moves or rests, the rest of that way is dropped, and it comes back into the mass as
/// it is then: all blows between blocks are contacts of the mass. So it does before it comes over terrain
/// that was dug out. What it does to trees counts for the mass from the time on at which it happens.
class HandOver {
public:
    HandOver() = default;  ///< hands nothing over
    HandOver(const CollapseScenario& scenario, const CollapseSite& site, double guard_s, std::uint64_t guards,
             rockfall::rock_mass::ParallelFor parallel);

    /// After the steps of a guard: trees that were hit since, and blocks that come back now.
    void guard(rockfall::rock_mass::RockMass& mass);
    /// After the guards of a look: blocks that leave the mass now.
    void look(rockfall::rock_mass::RockMass& mass);

    [[nodiscard]] std::span<const HandedFall> falls() const { return falls_; }
    /// When a fall began.
    [[nodiscard]] double start_s(std::size_t fall) const { return starts_s_[fall]; }
    /// How a fall ended in the mass, if it did; one that had come to rest may do so later.
    [[nodiscard]] const std::optional<Return>& return_of(std::size_t fall) const { return returns_[fall]; }
    /// Blocks that were handed over, however often.
    [[nodiscard]] std::size_t blocks() const;
    /// How often blocks came back: all of them, or one.
    [[nodiscard]] std::size_t returns() const;
    [[nodiscard]] std::size_t returns_of(std::size_t block) const;
    /// The fall of a block; nullptr: it is part of the mass.
    [[nodiscard]] const HandedFall* fall_of(std::size_t block) const {
        return block < fall_of_.size() && fall_of_[block] >= 0
                   ? &falls_[static_cast<std::size_t>(fall_of_[block])]
                   : nullptr;
    }
    /// When a block that is handed over left the mass.
    [[nodiscard]] double handed_at_s(std::size_t block) const {
        return starts_s_[static_cast<std::size_t>(fall_of_[block])];
    }
    /// Energy that a returning block got with the lift out of the ground of the mass, as its motion could not
    /// pay for all of it; 0 for falls that did not return.
    [[nodiscard]] double lift_given_j(std::size_t fall, const rockfall::rock_mass::RockMass& mass) const;
    [[nodiscard]] bool was_ever_single(std::size_t block) const;
    /// Whether a block was a single one at a time that was looked at.
    [[nodiscard]] bool was_single(std::size_t block, double time_s) const;
    [[nodiscard]] SeenBlock seen(const rockfall::rock_mass::RockMass& mass, std::size_t block) const;
    /// Whether no block that is handed over moves any more.
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
    void follow_again(std::span<const std::size_t> falls);
    void follow_from(std::size_t first_fall);
    void load_stems(rockfall::rock_mass::RockMass& mass);
    [[nodiscard]] bool may_reach_dug(const BlockOnWay& block) const;
    [[nodiscard]] std::uint32_t falls_before(std::size_t fall) const;
    [[nodiscard]] std::vector<std::size_t> falls_to_end(const rockfall::rock_mass::RockMass& mass) const;
    [[nodiscard]] std::vector<BlockOnWay> as_all_move(const rockfall::rock_mass::RockMass& mass,
                                                      double time_s) const;
    [[nodiscard]] std::vector<BlockOnWay> after_any_blow(const rockfall::rock_mass::RockMass& mass,
                                                         double time_s,
                                                         std::span<const std::uint8_t> comes_back) const;

    const CollapseSite* site_ = nullptr;
    FallSettings settings_;
    double look_s_ = 0.0;
    double after_s_ = 0.0;
    rockfall::rock_mass::ParallelFor parallel_;
    std::vector<Crossing> crossings_;
    std::vector<double> starts_s_;
    std::vector<std::optional<Return>> returns_;
    std::vector<HandedFall> falls_;
    std::vector<std::size_t> blows_done_;
    std::vector<std::int32_t> fall_of_;  ///< by block, the present one; -1: none
};

}  // namespace coupling::collapse
