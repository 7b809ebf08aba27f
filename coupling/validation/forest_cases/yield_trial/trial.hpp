#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "config/units/angle.hpp"
#include "forest/climate/series.hpp"
#include "forest/parameters.hpp"
#include "forest/patch.hpp"
#include "forest/species.hpp"
#include "forest/tables.hpp"

namespace coupling::validation::forest_cases::yield_trial {

/// Ground of a trial where nothing else is known: the model's own soil, but not acid.
inline constexpr forest::Soil trial_soil{.ph = 6.0};

/// A plantation of one species on a level hectare that borders on itself. forest::grow_year grows it under
/// `parameters`, which say which processes are off.
struct YieldTrial {
    forest::SpeciesId species{};
    forest::Soil soil = trial_soil;
    std::vector<forest::ClimateYear> weather;  ///< taken in turn, over and over; at least one
    config::Angle latitude = config::Angle::from_degrees(47.7);
    int start_age_years = 12;
    double stems_pha = 3000.0;
    double start_dbh_cm = 2.0;
    double start_scatter =
        0.33;  ///< standard deviation of the first diameters / their mean: that of a Weibull of shape 3.3
    forest::Parameters parameters;
    std::uint64_t seed = 1;
};

/// A stand at an age.
struct TrialState {
    int age_years = 0;
    forest::StandFigures figures;
};

/// The stand of a trial at the ages asked for (rising, from the start age on).
std::vector<TrialState> grow_trial(const YieldTrial& trial, const forest::SpeciesTable& species,
                                   std::span<const int> ages_years);

}  // namespace coupling::validation::forest_cases::yield_trial
