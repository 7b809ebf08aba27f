#include "forest/disturbance/disturbance.hpp"

#include <algorithm>

#include "forest/disturbance/beetle.hpp"
#include "forest/disturbance/snow_breakage.hpp"
#include "forest/disturbance/wind.hpp"

namespace forest {

namespace {

/// In a year with beetles from outside as many of them as were asked for, unless more come of themselves.
BeetleSources beetle_sources_in(const DisturbanceLaw& law, int year) {
    const bool come_in =
        std::find(law.beetle_years.begin(), law.beetle_years.end(), year) != law.beetle_years.end();
    return {.in_windthrow = law.beetle_in_windthrow,
            .background_pha =
                come_in ? std::max(law.beetle_background, law.beetle_years_pha) : law.beetle_background};
}

}  // namespace

void disturb(Stand& stand, const Site& site, const SpeciesTable& species, const SiteWeather& weather,
             const SpeciesDrought& drought, const DisturbanceLaw& law, std::uint64_t seed,
             std::uint32_t replicate) {
    if (law.snow) {
        break_by_snow(stand, site, species, weather.units, law.wet_snow_chance, seed, replicate);
    }
    if (const std::optional<Storm> storm = storm_of_year(law, seed, replicate, stand.year())) {
        throw_by_wind(stand, species, site.windows(), *storm, seed, replicate);
    }
    if (law.beetle) {
        attack_by_beetles(stand, site, species, weather, drought, beetle_sources_in(law, stand.year()), seed,
                          replicate);
    }
}

}  // namespace forest
