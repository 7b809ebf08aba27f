#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "coupling/inputs/observed/events.hpp"
#include "coupling/inputs/site.hpp"
#include "rockfall/tally/impact_log.hpp"

namespace coupling::observed {

/// Rocks whose impacts are held against observed ones, spread evenly over all rocks; about 2000 at most.
std::vector<std::uint64_t> rocks_for_impacts(std::uint64_t rocks);

/// The impacts of rocks on one slope.
std::vector<SimulatedImpact> simulated_impacts(std::span<const rockfall::RockImpacts> rocks,
                                               rockfall::Cover cover);

/// Observed passages and impacts of a site beside simulated ones; empty where none were observed. `rocks`:
/// that fell.
std::vector<EventComparison> compare_events(const Site& site, std::span<const SimulatedPassage> passages,
                                            std::span<const SimulatedImpact> impacts, std::uint64_t rocks);

}  // namespace coupling::observed
