#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rockfall/tally/ensemble_tally.hpp"

namespace coupling {

/// Targets that pages and the screen have room for: cards on a first screen, rows and charts below it
/// [choice]. The tables have all.
inline constexpr std::size_t most_target_cards = 4;
inline constexpr std::size_t most_targets_shown = 10;

/// Of the given targets, by number, those that most rocks reach over the bare slope, the most reached first.
/// No more than `most` keep their order.
std::vector<std::size_t> most_reached(std::span<const rockfall::TargetTally> tallies,
                                      std::vector<std::size_t> targets, std::size_t most);
/// The same of all targets.
std::vector<std::size_t> most_reached(std::span<const rockfall::TargetTally> tallies, std::size_t most);

}  // namespace coupling
