#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "coupling/results/figures/figures.hpp"

namespace coupling {

/// What ends a fall, as far as protection asks: all reasons of the ground are one.
enum class StopCause : std::uint8_t { tree, log, net, ground, left_terrain, gave_up };
inline constexpr std::size_t stop_causes = 6;

/// As tables name them, such as "left_terrain".
const char* name_of(StopCause cause);
StopCause cause_of(rockfall::StopReason reason);

/// Share of the rocks on a slope for each cause, with exact 95 % intervals; they add up to all rocks.
std::array<Share, stop_causes> shares_by_cause(const SlopeFigures& slope);

}  // namespace coupling
