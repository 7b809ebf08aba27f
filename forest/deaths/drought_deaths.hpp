#pragma once

#include <vector>

#include "forest/stand/species.hpp"
#include "forest/stand/species_drought.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// Deaths of trees by drought.
struct DroughtDeaths {
    double at_full_drought = 0.2;  ///< probability a year where stomata are never open [choice]
};

/// Probability of a tree to die of the drought of a year [0, 1]: nothing up to the tolerated drought, from
/// there in proportion up to `at_full_drought` [choice]. `response` is how far the stomata of the species
/// were open over the growing season (SpeciesDrought); its drought is 1 - response.
double drought_death(double response, const DroughtDeaths& law);

/// The same for each tree of a stand, in their order.
std::vector<double> drought_death_chances(const Stand& stand, const SpeciesDrought& drought,
                                          const DroughtDeaths& law);

}  // namespace forest
