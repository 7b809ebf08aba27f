#pragma once

#include <span>
#include <vector>

#include "forest/climate/series.hpp"
#include "forest/light/light.hpp"
#include "forest/production/unit_production.hpp"
#include "forest/production/water_balance.hpp"
#include "forest/site/processes.hpp"
#include "forest/site/site.hpp"
#include "forest/stand/species.hpp"
#include "forest/stand/species_drought.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// The weather of a year on a site.
struct SiteWeather {
    std::span<const ClimateYear> units;  ///< one for each site unit, at its elevation
    double co2_ppm = 350.0;
    bool co2_response = false;  ///< whether trees respond to it; otherwise as at 350 ppm
    /// Rain of June to August in a usual year of each site unit; empty = every summer counts as usual. Bark
    /// beetles start fewer outbreaks in wet ones.
    std::span<const double> usual_summer_mm{};
};

/// Where a year's water went, mean over the patches [mm]. Precipitation = evapotranspiration + runoff + what
/// soil and snow gained.
struct WaterYear {
    double precipitation_mm = 0.0;
    double evapotranspiration_mm = 0.0;
    double transpiration_mm = 0.0;
    double runoff_mm = 0.0;
    double storage_gain_mm = 0.0;
};

/// Result of twelve months: state of the patches and production per absorbed light.
struct Season {
    std::vector<PatchState> patches;        ///< after the year
    std::vector<YearOfLightUse> light_use;  ///< by production unit and species
    std::vector<double> degree_days;        ///< above 5.5 degC, by site unit
    SpeciesDrought drought;
    WaterYear water;
};

/// Light of the year on the flat and which months have leaves. Radiation is that of the first site unit: it
/// does not change with elevation.
LightYear light_year_of(const Site& site, const SpeciesTable& species, const SiteWeather& weather);

/// Month by month: snow, rain and interception, transpiration, soil water, and the modifiers of production
/// that result from them. Leaf area of a patch is that of the trees that stand on it.
///
/// Without Processes::water nothing is short of water: soil and snow stay as they are, no patch has a
/// drought, and the flows of `Season::water` are 0.
Season compute_season(const Stand& stand, const Site& site, const SpeciesTable& species,
                      const SiteWeather& weather, const LightYear& light_year, const LightField& light,
                      const Processes& processes);

}  // namespace forest
