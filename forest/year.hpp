#pragma once

#include <cstdint>

#include "forest/parameters.hpp"
#include "forest/season.hpp"
#include "forest/site.hpp"
#include "forest/species.hpp"
#include "forest/stand.hpp"

namespace forest {

/// Whose chance decides.
struct YearKey {
    std::uint64_t seed = 0;
    std::uint32_t replicate = 0;
};

/// What a year was like, beside what the stand itself holds (its balance, deaths, patches).
struct YearReport {
    double volume_increment_m3 = 0.0;  ///< stem wood that the trees of the year's beginning put on
    double production_kg = 0.0;        ///< net primary production of all trees
    WaterYear water;
    double light_closure =
        1.0;  ///< intercepted light / light on the leaves, July; far from 1 = the light model fails
};

/// One year of a forest: it becomes light, trees produce and grow, some die, snow, storm and beetles strike
/// if they are switched on, young trees come up, dead wood decays and falls.
///
/// Nothing but the arguments decides, and not the order of trees: the same stand, weather and key give the
/// same bytes. Requires a stand on the grid that the site was made for, and weather for each of the site's
/// units.
YearReport grow_year(Stand& stand, const Site& site, const SpeciesTable& species, const SiteWeather& weather,
                     const Parameters& parameters, const YearKey& key);

}  // namespace forest
