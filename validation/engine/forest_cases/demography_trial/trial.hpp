#pragma once

#include <cstdint>
#include <vector>

#include "config/units/angle.hpp"
#include "forest/climate/series.hpp"
#include "forest/parameters.hpp"
#include "forest/site/site.hpp"
#include "forest/stand/species.hpp"
#include "forest/year.hpp"

namespace coupling::validation::forest_cases::demography_trial {

/// Climate of a place as inventories describe it.
struct PlaceClimate {
    double degree_days = 0.0;  ///< above 5.5 degC
    double wetness = 0.0;      ///< (P - PET) / PET of a year
};

/// Mean over the years; potential evapotranspiration by Turc's rule for months.
PlaceClimate climate_of(const std::vector<forest::ClimateYear>& years);

/// The years shifted by one temperature and one factor of precipitation, all months alike, until their means
/// are those asked for: degree-days within 0.1 %, wetness to rounding. Requires a climate that a shift of 15
/// K reaches.
std::vector<forest::ClimateYear> shifted_to(const std::vector<forest::ClimateYear>& years,
                                            const PlaceClimate& wanted);

/// Trees of one size among larger ones of the same species, all of one size: four on a quarter of a hectare
/// that borders on itself, 25 m apart. The larger ones are 10 cm thicker.
struct DemographyTrial {
    forest::SpeciesId species{};
    double dbh_cm = 0.0;
    double larger_m2pha = 0.0;                 ///< basal area of the larger trees
    std::vector<forest::ClimateYear> climate;  ///< years are drawn from these
    double degree_days = 0.0;                  ///< mean of the climate: heights follow from it
    forest::Parameters parameters;
    int years = 10;
};

/// What became of the trees.
struct Fate {
    std::uint64_t trees = 0;
    std::uint64_t survivors = 0;
    double growth_mm_pyear = 0.0;  ///< diameter, summed over survivors

    Fate& operator+=(const Fate& other);
    [[nodiscard]] double mean_growth_mm_pyear() const;
    [[nodiscard]] double mortality_pyear(int years) const;
};

/// Ground of all trials.
forest::PatchGrid trial_grid();

/// Grows one stand. `site` is that of trial_grid().
Fate grow_demography(const DemographyTrial& trial, const forest::Site& site,
                     const forest::SpeciesTable& species, const forest::YearKey& key);

}  // namespace coupling::validation::forest_cases::demography_trial
