#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rockfall/ensemble.hpp"
#include "rockfall/tally/impact_log.hpp"

namespace coupling {

/// Lets single rocks fall once more, over each slope of the assessment, and keeps their impacts. The same
/// key gives the same fall. Requires rising numbers of rocks that exist, and an assessment in which nothing
/// breaks for good.
std::vector<rockfall::RockImpacts> impacts_of(const rockfall::Assessment& assessment,
                                              std::span<const std::uint64_t> rocks);

}  // namespace coupling
