#pragma once

#include "coupling/assessments/collapse/collapse_results.hpp"
#include "coupling/results/figures/departures.hpp"

namespace coupling::collapse {

/// Blocks that went on as single ones and left the terrain, by part of its rim.
Departures departures_of_single_blocks(const HandOver& hand_over, const CollapseSite& site);

/// From departures_to_warn_of on.
void warn_of_departures(const Departures& departures, config::Warnings& warnings);

}  // namespace coupling::collapse
