#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "forest/climate/series.hpp"
#include "forest/regeneration/seed_rain.hpp"
#include "forest/site/site.hpp"
#include "forest/stand/species.hpp"
#include "forest/stand/species_drought.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// What a user can say about regeneration.
struct RegenerationLaw {
    SeedsFromOutside outside;
    double browsing_pressure = 1.0;  ///< >= 0: 0 fenced, 1 normal, 3 high
};

/// A year of regeneration: herb cover follows the light, saplings grow, are browsed and die, the densest
/// lose their smallest, the tallest become trees; seeds fall and germinate where seed bed and climate allow;
/// stumps sprout.
///
/// Runs after growth and death of the trees, with the light of the season in the patch states. `weather` has
/// one year for each of the site's units. Chance is drawn by patch and year.
void regenerate(Stand& stand, const Site& site, const SpeciesTable& species,
                std::span<const ClimateYear> weather, const SpeciesDrought& drought,
                const RegenerationLaw& law, std::uint64_t seed, std::uint32_t replicate);

/// Three sprouts of 0.5 m for each stump or broken stem of last year, thinner than 30 cm, of a species that
/// sprouts [choice].
std::vector<Cohort> sprouts_of(const Stand& stand, const SpeciesTable& species);

}  // namespace forest
