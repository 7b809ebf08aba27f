#pragma once

#include <cstdint>
#include <span>

#include "forest/climate/series.hpp"
#include "forest/site/site.hpp"
#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// Thinner stems bend instead [choice].
inline constexpr double least_broken_cm = 10.0;

/// Chance of a tree to break under wet snow: logistic(-10.5 + 0.07 * 100 H / D) for conifers, H in m and D in
/// cm; 0 for broadleaves. The slope is a choice; the level was set so that snow takes a fraction of what
/// storms take in old forests (in Europe storms took 53 % of the damaged wood, snow 3 %; Schelhaas et al.
/// 2003 [lit*]).
double snow_breakage(const Species& species, double dbh_cm, double height_m);

/// In a year of wet snow slender conifers break in the middle third of their height [choice] and leave for
/// Cause::snow; the tops lie down the slope, 60 degrees either way.
///
/// Each site unit has its own chance of such a year, by its weather (wet_snow.hpp); `usual_chance` is that at
/// 500 to 1300 m in 1950-2010. One number is drawn a year for all units, so that a snowfall covers all
/// elevations where snow was wet enough. Breakage is drawn by tree and year. Requires weather for each unit.
void break_by_snow(Stand& stand, const Site& site, const SpeciesTable& species,
                   std::span<const ClimateYear> weather, double usual_chance, std::uint64_t seed,
                   std::uint32_t replicate);

}  // namespace forest
