#pragma once

#include "forest/parameters.hpp"
#include "forest/stand/species.hpp"

namespace forest {

/// Factors on what is not known of a forest, the same for all species; 1 changes no bit.
struct ForestFactors {
    double growth = 1.0;  ///< production of each tree
    double deaths = 1.0;  ///< chance to die of age, size, stress or shade; storms and drought are others
    double regeneration = 1.0;  ///< seedlings that come of a crop, from inside and outside
};

SpeciesTable with_factors(const SpeciesTable& species, const ForestFactors& factors);
Parameters with_factors(const Parameters& parameters, const ForestFactors& factors);

}  // namespace forest
