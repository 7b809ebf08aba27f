#pragma once

#include <cstdint>
#include <vector>

#include "forest/season.hpp"
#include "forest/site.hpp"
#include "forest/species.hpp"
#include "forest/stand.hpp"

namespace forest {

/// Where beetles come from.
struct BeetleSources {
    double in_windthrow = 0.05;        ///< [0, 1], chance of a patch with last year's windthrown hosts
    double background_pha = 0.000685;  ///< [0, 1), chance of a hectare of host patches, a year
};

/// Thinner spruces are not attacked.
inline constexpr double least_host_cm = 15.0;

/// How easily beetles take the hosts of each patch [0, 1]; below 0 where there are none.
///
/// 0.15 + 0.85 stress (iLand); stress is the larger of the year's drought index and the share of hosts with a
/// year of poor growth [choice].
std::vector<double> colonisation_success(const Stand& stand, const SpeciesTable& species);

/// Share of its cohorts that an outbreak loses to its enemies in its n-th year: 0 in the first half of the
/// duration that it can have, rising to 1 at its end (form iLand).
double lost_to_enemies(int outbreak_year, double duration_years);

/// A season of bark beetles on spruce (iLand bark beetle module, PHENIPS).
///
/// They fly from patches where they wintered, from a share of those with windthrown hosts that still lie
/// there a year later, and from a few others, more in dry summers. As often as their broods allow, each
/// patch sends 20 cohorts, 30 with a sister brood, to normal distances of 40.5 m a side, 257 m at most; a
/// cohort that meets no host looks over the eight patches around. Hosts of patches that are taken or left die
/// for Cause::beetle. Beetles of the last flight winter where they are.
///
/// Chance is drawn by patch and year; all patches of a flight start from the same state, so that no order
/// matters.
void attack_by_beetles(Stand& stand, const Site& site, const SpeciesTable& species,
                       const SiteWeather& weather, const BeetleSources& sources, std::uint64_t seed,
                       std::uint32_t replicate);

}  // namespace forest
