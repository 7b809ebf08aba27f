#pragma once

#include <span>
#include <vector>

#include "config/grid/raster.hpp"
#include "coupling/assessments/hazard/hazard_matrix.hpp"
#include "coupling/assessments/hazard/hazard_rules.hpp"

namespace coupling::hazard {

/// What the rocks of one return period do on one slope, on the frame of the maps; NaN where none passes.
struct PeriodFalls {
    double return_period_years = 0.0;
    config::Raster<float> passages;  ///< rocks that pass
    config::Raster<float> reach_percent;
    config::Raster<float> energy_kj;   ///< hazard.energy
    config::Raster<float> largest_kj;  ///< of all rocks
    /// How many rocks pass for each release, with energies as `rockfall::CellReleases` counts them.
    std::vector<config::Raster<float>> per_release;
};

/// How many of the rocks of a cell have at least an energy, from their numbers with each energy of
/// `rockfall::CellReleases` and above: exact there, straight between, and down to none above the largest.
double per_release_from(double energy_kj, std::span<const double> per_release, double largest_kj);

/// The danger on one slope by a rule; NaN where no rock that counts passes.
struct HazardMap {
    HazardRule rule = HazardRule::release;
    config::Raster<float> level;                   ///< number of the Level
    config::Raster<float> ruling_years;            ///< return period of the release that gives this level
    config::Raster<float> rocks;                   ///< how many simulated ones give it, about
    std::vector<config::Raster<float>> intensity;  ///< by return period: number of the class from 1
    /// By return period of the release: mean time between two arrivals in the cell [years].
    std::vector<config::Raster<float>> arrival_years;
};

/// The hazard map of falls on the same frame: the level of each cell is that of `level_of`. A rock counts in
/// a cell as at a target: how often a rock passes it is the frequency of the release times the share that
/// passes, added up over the rows of hazard.blocks. So rocks pass a cell that lies in an area at most as
/// often as they hit that area. A cell counts in a period if its reach probability is at least
/// `least_reach_percent`. Requires at least one period.
HazardMap hazard_map(HazardRule rule, std::span<const PeriodFalls> periods, const Matrix& matrix,
                     double least_reach_percent);

}  // namespace coupling::hazard
