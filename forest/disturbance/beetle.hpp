#pragma once

#include <cstdint>

#include "forest/site/season.hpp"
#include "forest/site/site.hpp"
#include "forest/stand/species.hpp"
#include "forest/stand/species_drought.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// Where beetles come from.
struct BeetleSources {
    double in_windthrow = 0.05;    ///< [0, 1], chance of a patch with last year's windthrown hosts
    double background_pha = 0.08;  ///< [0, 1), chance of a hectare of host patches, in a usual year
};

/// Share of its cohorts that an outbreak loses to its enemies in its n-th year: 0 in the first half of the
/// duration that it can have, rising to 1 at its end (form iLand).
double lost_to_enemies(int outbreak_year, double duration_years);

/// A season of bark beetles on spruce (iLand bark beetle module, PHENIPS; by tree: choice).
///
/// They fly from patches where they wintered, from a share of those with windthrown hosts that still lie
/// there a year later, and from a few others, more in dry summers (iLand) and in warm years: the odds are
/// three times as large in a year with 400 degree-days above the usual ones, about 2 K [fit: Switzerland lost
/// 0.05 % of its spruce stock a year from 1997 to 1999 and 1.2 % in 2003]. As often as their broods allow,
/// each patch sends 4 cohorts, 6 with a sister brood [fit; iLand 20 and 30], times its brood: the basal area
/// of the hosts that they grew in / 0.3 m2, at most 1. The first attacks the patch that it comes from, the
/// others fly normal distances of 40.5 m a side, 257 m at most; a cohort that meets no host looks over the
/// eight patches around.
///
/// Each host of a patch where n cohorts land dies with 1 - (1 - s)^n, s its colonisation_success(): few where
/// spruce is one of several species, young or well watered, nearly all in a pure, dry, old stand. A patch
/// where a tree was killed has beetles; those of the last flight winter there. Dead trees leave for
/// Cause::beetle.
///
/// Chance is drawn by patch, tree and year; all patches of a flight start from the same state, so that no
/// order matters. Limit: beetles that leave the area are lost; those from outside come only as a larger
/// background_pha.
void attack_by_beetles(Stand& stand, const Site& site, const SpeciesTable& species,
                       const SiteWeather& weather, const SpeciesDrought& drought,
                       const BeetleSources& sources, std::uint64_t seed, std::uint32_t replicate);

}  // namespace forest
