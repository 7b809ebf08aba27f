#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "coupling/inputs/observed/stops.hpp"
#include "rockfall/terrain/terrain.hpp"
#include "validation/engine/case/comparison.hpp"

namespace coupling::validation {

/// How far the rocks of a state got: reach and shadow angles of those that stopped after a fall of more than
/// 50 m, as published ranges are those of long falls. Rocks that left the terrain have none; their share
/// stands beside.
struct ReachSample {
    std::vector<double> reach_deg;
    std::vector<double> shadow_deg;  ///< of those that did not stop on a cliff
    std::size_t rocks = 0;           ///< all of the state
    std::size_t left = 0;            ///< those that left the terrain
};

/// Stops have absolute coordinates.
ReachSample reach_sample_of(const rockfall::Terrain& terrain, std::span<const observed::SimulatedStop> stops);

/// Names `shadow_below_27.5_percent:STATE` (share of stops under less than the least shadow angle of Evans &
/// Hungr 1993), `reach_angle_p01_deg:STATE`, `reach_angle_mean_deg:STATE` and `left_percent:STATE`.
void name_reach_figures(const std::string& state, const std::string& meaning, Comparison& comparison);

/// Enters them. Figures of an empty sample are left out.
void take_reach_figures(const std::string& state, const ReachSample& sample, Outcome& outcome);

/// A row of the table of distributions: quantiles of both angles.
std::vector<std::string> reach_row(const std::string& meaning, const ReachSample& sample);
PlainTable reach_table();

}  // namespace coupling::validation
