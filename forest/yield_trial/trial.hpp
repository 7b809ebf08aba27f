#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "forest/mortality.hpp"
#include "forest/species.hpp"
#include "forest/tables.hpp"
#include "forest/unit_production.hpp"

namespace forest {

/// One year of weather of a trial, on the flat.
struct TrialYear {
    std::array<MonthConditions, 12> months{};
    std::array<double, 12> radiation_mjpm2{};  ///< global, month sums
    double degree_days = 0.0;                  ///< above 5.5 degC
};

/// A plantation of one species, left to itself: only stress and self-thinning take trees.
struct YieldTrial {
    SpeciesId species{};
    double fertility = 0.7;
    double ph = 6.0;
    std::vector<TrialYear> weather;  ///< taken in turn, over and over; at least one
    int start_age_years = 12;
    double stems_pha = 3000.0;
    double start_dbh_cm = 2.0;
    double start_scatter = 0.2;  ///< standard deviation of the first diameters / their mean [choice]
    double stress_death = 0.02;  ///< chance a year after three bad ones
    std::uint64_t seed = 1;
};

/// A stand at an age.
struct TrialState {
    int age_years = 0;
    StandFigures figures;
};

/// The stand of a trial on one hectare at the ages asked for (rising, from the start age on), in light by
/// layers: without places.
std::vector<TrialState> grow_in_layers(const YieldTrial& trial, const SpeciesTable& species,
                                       std::span<const int> ages_years);

}  // namespace forest
