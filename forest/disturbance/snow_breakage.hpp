#pragma once

#include <cstdint>

#include "forest/species.hpp"
#include "forest/stand.hpp"

namespace forest {

/// Elevations where snow falls wet [choice].
inline constexpr double lowest_wet_snow_m = 500.0;
inline constexpr double highest_wet_snow_m = 1300.0;

/// Thinner stems bend instead [choice].
inline constexpr double least_broken_cm = 10.0;

/// Chance of a tree to break under wet snow: logistic(-8 + 0.07 * 100 H / D) for conifers, H in m and D in cm
/// [choice]; 0 for broadleaves.
double snow_breakage(const Species& species, double dbh_cm, double height_m);

/// In a wet-snow year, which has the probability `chance`, slender conifers at 500 to 1300 m break in the
/// middle third of their height [choice] and leave for Cause::snow; the tops lie down the slope, 60 degrees
/// either way. Chance is drawn by tree and year.
void break_by_snow(Stand& stand, const SpeciesTable& species, double chance, std::uint64_t seed,
                   std::uint32_t replicate);

}  // namespace forest
