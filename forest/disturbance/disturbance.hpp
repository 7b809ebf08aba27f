#pragma once

#include <cstdint>
#include <vector>

#include "forest/site/season.hpp"
#include "forest/site/site.hpp"
#include "forest/stand/species.hpp"
#include "forest/stand/species_drought.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// Which disturbances happen, and how often. All are off by default.
struct DisturbanceLaw {
    bool wind = false;
    bool snow = false;
    bool beetle = false;
    double storm_interval_years = 25.0;  ///< >= 1, mean time from storm to storm [Barrere et al. 2023]
    double wet_snow_chance = 0.05;       ///< [0, 1] a year at 500-1300 m, 1950-2010 [choice]
    double beetle_in_windthrow = 0.05;   ///< [0, 1] a patch with fresh wood of hosts [choice; iLand 0.8]
    double beetle_background = 0.08;     ///< [0, 1) a hectare of hosts and year, spots of themselves [fit]
    std::uint64_t first_year = 0;        ///< calendar year with which they begin; 0: all years
    std::vector<double> storm_years{};   ///< calendar years in which a storm comes for sure
    double intensity_asked_for = 0.6;    ///< [0, 1] of these storms
    std::vector<double> beetle_years{};  ///< calendar years in which beetles come in from outside
    double beetle_years_pha = 0.5;       ///< [0, 1) chance of a hectare of hosts in such a year [choice]

    /// Whether storms can come at all.
    [[nodiscard]] bool has_storms() const { return wind || !storm_years.empty(); }

    /// As it holds in a calendar year: before the first one nothing happens but the storms asked for.
    [[nodiscard]] DisturbanceLaw in_year(int year) const {
        DisturbanceLaw law = *this;
        if (year < static_cast<int>(first_year)) {
            law.wind = law.snow = law.beetle = false;
        }
        return law;
    }
};

/// Snow breakage, storm and bark beetles of the running year, in this order, as far as they are switched on.
///
/// Each draws from numbers of its own, so that none changes another's chance. What outlives the year stands
/// in the stand: fallen wood among the logs, wintering beetles among the patches' states. Requires the light,
/// water and growth of the year.
void disturb(Stand& stand, const Site& site, const SpeciesTable& species, const SiteWeather& weather,
             const SpeciesDrought& drought, const DisturbanceLaw& law, std::uint64_t seed,
             std::uint32_t replicate);

}  // namespace forest
