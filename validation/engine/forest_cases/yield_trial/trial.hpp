#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "config/units/angle.hpp"
#include "forest/climate/series.hpp"
#include "forest/inventory/tables.hpp"
#include "forest/parameters.hpp"
#include "forest/stand/patch.hpp"
#include "forest/stand/species.hpp"

namespace coupling::validation::forest_cases::yield_trial {

/// Ground of a trial where nothing else is known: the model's own soil, but not acid.
inline constexpr forest::Soil trial_soil{.ph = 6.0};

/// What a stand of one species is at an age.
struct StandAtAge {
    int age_years = 0;
    double stems_pha = 0.0;
    double mean_dbh_cm = 0.0;    ///< quadratic
    double mean_height_m = 0.0;  ///< of the tree of that diameter
};

/// Stems that a treatment leaves at an age: the thinnest go.
struct Thinning {
    int age_years = 0;
    double stems_pha = 0.0;
};

/// A stand of one species on a level hectare that borders on itself. forest::grow_year grows it under
/// `parameters`, which say which processes are off.
struct YieldTrial {
    forest::SpeciesId species{};
    forest::Soil soil = trial_soil;
    std::vector<forest::ClimateYear> weather;  ///< taken in turn, over and over; at least one
    config::Angle latitude = config::Angle::from_degrees(47.7);
    StandAtAge start{.age_years = 12, .stems_pha = 3000.0, .mean_dbh_cm = 2.0, .mean_height_m = 2.2};
    std::vector<Thinning> thinnings;  ///< by rising age; empty: the stand is left alone
    forest::Parameters parameters;
    std::uint64_t seed = 1;
};

/// A stand at an age.
struct TrialState {
    int age_years = 0;
    forest::StandFigures figures;
    double mean_height_m = 0.0;         ///< of stems within a tenth of the quadratic mean diameter
    double dominant_slenderness = 0.0;  ///< height [m] / diameter [m] of the 100 thickest stems
};

/// A trial from its start to the last age asked for.
struct TrialRun {
    std::vector<TrialState> states;         ///< at the ages asked for
    double greatest_density = 0.0;          ///< stems of 7 cm and more / self-thinning line, in any year
    std::optional<double> density_at_25cm;  ///< the same in the first year of a mean diameter of 25 cm
};

/// Grows a trial. Ages rise and are not below that of the start. A thinning of an age comes before its state.
TrialRun grow_trial(const YieldTrial& trial, const forest::SpeciesTable& species,
                    std::span<const int> ages_years);

}  // namespace coupling::validation::forest_cases::yield_trial
