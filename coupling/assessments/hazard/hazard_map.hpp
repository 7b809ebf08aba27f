#pragma once

#include <array>
#include <span>
#include <vector>

#include "config/grid/raster.hpp"
#include "coupling/assessments/hazard/hazard_matrix.hpp"
#include "coupling/assessments/hazard/hazard_rules.hpp"

namespace coupling::hazard {

/// The percentiles of energies that a run writes as rasters: stem, and the share of the rocks below.
struct QuantileRaster {
    const char* stem;
    double share_below;
};
inline constexpr std::array<QuantileRaster, 6> quantile_rasters{
    {{"E_50", 0.5}, {"E_90", 0.9}, {"E_95", 0.95}, {"E_98", 0.98}, {"E_99", 0.99}, {"E_max", 1.0}}};

/// What the rocks of one return period do on one slope, on the frame of the maps; NaN where none passes.
struct PeriodFalls {
    double return_period_years = 0.0;
    config::Raster<float> reach_percent;
    config::Raster<float> energy_kj;  ///< hazard.energy; only of the rules arrival and release
    std::vector<config::Raster<float>> quantiles_kj;  ///< as quantile_rasters; only of the rule cadanav
};

/// The danger on one slope by a rule; NaN where no rock that counts passes.
struct HazardMap {
    HazardRule rule = HazardRule::release;
    config::Raster<float> level;                   ///< number of the Level
    config::Raster<float> ruling_years;            ///< return period of the release that gives this level
    std::vector<config::Raster<float>> intensity;  ///< by return period: number of the class from 1
    /// By return period of the release: mean time between two arrivals in the cell [years].
    std::vector<config::Raster<float>> arrival_years;
};

/// The hazard map of falls on the same frame: in each cell the highest level of all return periods. A cell
/// counts in a period if its reach probability is at least `least_reach_percent`. Each return period is
/// judged by itself: frequencies of several are not added up. Requires at least one period.
HazardMap hazard_map(HazardRule rule, std::span<const PeriodFalls> periods, const Matrix& matrix,
                     double least_reach_percent);

}  // namespace coupling::hazard
