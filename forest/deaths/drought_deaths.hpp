#pragma once

#include <vector>

#include "forest/stand/species.hpp"
#include "forest/stand/species_drought.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// Deaths of trees by drought.
struct DroughtDeaths {
    double at_full_drought = 1.0;  ///< probability a year where stomata are never open [choice]
};

/// Probability of a tree to die of the drought of a year [0, 1]: nothing up to the tolerated drought, from
/// there on a x^1.5 with `at_full_drought` a and x from 0 to 1 [choice: a tree whose stomata never open dies;
/// the power with forest_dry and the stems of forest_hauersteig in view, as mild droughts kill few].
/// `response` is how far the stomata of the species
/// were open over the growing season (SpeciesDrought); its drought is 1 - response.
double drought_death(double response, const DroughtDeaths& law);

/// The same for each tree of a stand, in their order.
std::vector<double> drought_death_chances(const Stand& stand, const SpeciesDrought& drought,
                                          const DroughtDeaths& law);

}  // namespace forest
