#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "config/units/angle.hpp"
#include "forest/climate/sequence.hpp"
#include "forest/deadwood/decay_class.hpp"
#include "forest/parameters.hpp"
#include "forest/stand/patch.hpp"
#include "forest/stand/species.hpp"
#include "forest/stand/stand_balance.hpp"
#include "forest/year.hpp"

namespace coupling::validation::forest_cases::succession_trial {

/// Bare level ground in a region that has all species of the table, left to itself. The area borders on
/// itself.
struct SuccessionTrial {
    forest::Soil soil;
    forest::ClimateSeries climate;  ///< at the place; whole years of it are drawn from `window`
    forest::YearWindow window;      ///< requires years of the series
    config::Angle latitude = config::Angle::from_degrees(47.7);
    int side_patches = 10;  ///< 10: one hectare
    int years = 400;
    int interval_years = 10;        ///< between two states
    int disturbed_from_year = 1;    ///< storms, snow and beetles, where parameters have them on, begin here
    forest::Parameters parameters;  ///< with the processes that are switched off
};

/// What one species makes up.
struct SpeciesShare {
    double biomass_tpha = 0.0;  ///< above ground, dry
    double basal_area_m2pha = 0.0;
    double stems_pha = 0.0;  ///< of 1 cm and more
    double stems_10cm_pha = 0.0;
};

/// Trees by size, for their deaths: from 10, 20, 40 and 60 cm diameter on.
inline constexpr std::array<double, 4> death_class_from_cm{10.0, 20.0, 40.0, 60.0};

/// Trees that lived and died in some years.
struct Deaths {
    double tree_years = 0.0;
    double deaths = 0.0;
};

/// A stand in one year of its succession.
struct SuccessionState {
    int year = 0;                       ///< since bare ground
    std::vector<SpeciesShare> species;  ///< in the order of the table
    double volume_m3pha = 0.0;
    double thick_stems_pha = 0.0;  ///< above 60 cm diameter
    double top_height_m = 0.0;     ///< of the 100 thickest stems of a hectare
    double dead_wood_m3pha = 0.0;  ///< standing and lying
    std::array<double, forest::decay_class_count> dead_wood_by_class_m3pha{};
    std::array<double, forest::cause_count>
        lost_m3pha{};            ///< stem wood a year since the state before, by cause
    double ground_light = 1.0;   ///< mean over the patches
    double drought_index = 0.0;  ///< mean over the patches and the years since the state before
    std::array<Deaths, death_class_from_cm.size()> deaths{};  ///< since the state before, by size

    [[nodiscard]] double biomass_tpha() const;
    [[nodiscard]] double basal_area_m2pha() const;
};

/// The states of a trial, one every interval, the last after its last year. Takes some seconds a hectare and
/// 400 years; the same key gives the same bytes, replicates are independent of each other and of threads, and
/// places draw the same years of weather.
std::vector<SuccessionState> grow_succession(const SuccessionTrial& trial,
                                             const forest::SpeciesTable& species, const forest::YearKey& key);

}  // namespace coupling::validation::forest_cases::succession_trial
