#pragma once

#include <cstdint>

#include "forest/parameters.hpp"
#include "forest/site/season.hpp"
#include "forest/site/site.hpp"
#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// Key of the random numbers of a run.
struct YearKey {
    std::uint64_t seed = 0;
    std::uint32_t replicate = 0;
};

/// Figures of a year that the stand itself does not hold (the stand holds its balance, deaths and patches).
struct YearReport {
    double volume_increment_m3 = 0.0;  ///< stem growth of the trees that stood at the beginning of the year
    double production_kg = 0.0;        ///< net primary production of all trees
    WaterYear water;
    double light_closure =
        1.0;  ///< intercepted light / light on the leaves, July; far from 1 = the light model fails
};

/// One year of a forest: light, water, production, growth, deaths, disturbances, regeneration, dead wood.
/// `parameters` switch processes off.
///
/// The result depends on the arguments alone and not on the order of trees: the same stand, weather and key
/// give the same bytes. Requires a stand on the grid that the site was made for, and weather for each of the
/// site's units.
YearReport grow_year(Stand& stand, const Site& site, const SpeciesTable& species, const SiteWeather& weather,
                     const Parameters& parameters, const YearKey& key);

}  // namespace forest
