#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "config/units/angle.hpp"
#include "forest/mortality.hpp"
#include "forest/species.hpp"
#include "forest/tables.hpp"
#include "forest/unit_production.hpp"

namespace coupling::validation::forest_cases::yield_trial {

/// One year of weather of a trial, on the flat.
struct TrialYear {
    std::array<forest::MonthConditions, 12> months{};
    std::array<double, 12> radiation_mjpm2{};  ///< global, month sums
    double degree_days = 0.0;                  ///< above 5.5 degC
};

/// How light gets to the trees of a trial.
enum class TrialLight : std::uint8_t {
    layers,  ///< trees without places (forest/layer_light.hpp)
    space,   ///< the model's own (forest/light), on a level hectare that borders on itself
};

/// A plantation of one species, left to itself: only stress and self-thinning take trees.
struct YieldTrial {
    forest::SpeciesId species{};
    double fertility = 0.7;
    double ph = 6.0;
    std::vector<TrialYear> weather;  ///< taken in turn, over and over; at least one
    config::Angle latitude = config::Angle::from_degrees(47.7);
    int start_age_years = 12;
    double stems_pha = 3000.0;
    double start_dbh_cm = 2.0;
    double start_scatter =
        0.33;  ///< standard deviation of the first diameters / their mean: that of a Weibull of shape 3.3
    forest::MortalityLaw mortality{.background = false};  ///< only stress and self-thinning
    std::uint64_t seed = 1;
};

/// A stand at an age.
struct TrialState {
    int age_years = 0;
    forest::StandFigures figures;
};

/// The stand of a trial on one level hectare at the ages asked for (rising, from the start age on).
std::vector<TrialState> grow_trial(const YieldTrial& trial, TrialLight light,
                                   const forest::SpeciesTable& species, std::span<const int> ages_years);

}  // namespace coupling::validation::forest_cases::yield_trial
