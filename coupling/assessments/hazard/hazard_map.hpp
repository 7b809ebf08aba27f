#pragma once

#include <array>
#include <span>
#include <vector>

#include "config/grid/raster.hpp"
#include "coupling/assessments/hazard/hazard_matrix.hpp"
#include "rockfall/tally/target.hpp"

namespace coupling::hazard {

/// What the rocks of one return period do on one slope, on the frame of the maps; NaN where none passes.
struct PeriodFalls {
    double return_period_years = 0.0;
    config::Raster<float> energy_kj;
    config::Raster<float> reach_percent;
};

/// The danger on one slope; NaN where no rock that counts passes.
struct HazardMap {
    config::Raster<float> level;                   ///< number of the Level
    config::Raster<float> ruling_years;            ///< shortest return period that gives this level
    std::vector<config::Raster<float>> intensity;  ///< by return period: number of the class from 1
    /// The same level with the return period of the arrival in the cell in place of that of the release.
    config::Raster<float> arrival_level;
    /// By return period of the release: mean time between two arrivals in the cell [years].
    std::vector<config::Raster<float>> arrival_years;
};

/// Mean time between two arrivals of rocks that are released once in a return period and of which a share
/// arrives: frequencies multiply, so that periods are divided by the share. Infinite for a share of 0.
double arrival_return_period_years(double release_years, double reach_percent);

/// The hazard map of falls on the same frame: in each cell the highest level of all return periods. A cell
/// counts in a period if its reach probability is at least `least_reach_percent`. Each return period is
/// judged by itself: frequencies of several are not added up. Requires at least one period.
HazardMap hazard_map(std::span<const PeriodFalls> periods, const Matrix& matrix, double least_reach_percent);

/// A cell that a target lies in, and how much of the target: m of a line, m2 of an area.
struct TargetPart {
    std::size_t cell = 0;
    double extent = 0.0;
};

/// The cells of a target on a frame in its coordinates; what lies off the frame is left out. Lines in steps
/// of a twentieth of a cell, areas in an eighth of one each way, half a metre at most.
std::vector<TargetPart> parts_of(const rockfall::Target& target, const config::GridFrame& frame);

/// How a target's extent is divided among the values of a raster from 0 to `count` - 1; NaN counts as 0.
/// Shares of its whole [0, 1]; all 0 for a target off the frame.
std::vector<double> shares_of(std::span<const TargetPart> parts, const config::Raster<float>& raster,
                              std::size_t count);

}  // namespace coupling::hazard
