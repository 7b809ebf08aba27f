#pragma once

#include <span>
#include <vector>

#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// A tree before its growth, as far as growth asks.
struct Size {
    double dbh_cm = 0.0;
    double height_m = 0.0;
    double completeness = 1.0;  ///< of foliage
};

/// What a year's production becomes.
struct Increment {
    double dbh_cm = 0.0;
    double height_m = 0.0;
    double used_kg = 0.0;  ///< of the gain; the rest found no place
};

/// Largest diameter growth of a year [choice].
inline constexpr double largest_increment_cm = 3.0;

/// Diameter and height growth from the above-ground gain of a year.
///
/// Solves  mass(D + dD, H + ratio dD) - mass(D, H) = gain  for dD >= 0, mass = stem + branches + foliage.
/// A tree that has reached its greatest height grows in diameter only; one at its greatest diameter, or
/// beyond largest_increment_cm in a year, has production left over. The mass is convex in dD, so Newton's
/// steps approach the root from above and never overshoot it.
///
/// A gain of 0 or less is no growth.
Increment increment_of(const Species& species, const Size& size, double ratio, double gain_kg);

/// What a tree has got to grow with, per stem.
struct TreeSeason {
    double npp_kg = 0.0;       ///< net primary production of the year, >= 0
    double root_share = 0.0;   ///< share of it for roots [0, 1)
    double degree_days = 0.0;  ///< above 5.5 degC, of the year
    double site_height_m =
        0.0;  ///< > 0, greatest height of its species at the place (forest/stand/site_height.hpp)
    double shaded_below_m = 0.0;  ///< height below which leaves of its species get too little light
};

/// The year's growth of every tree, in their order. Requires one season a tree.
std::vector<TreeGrowth> growth_of_trees(const Stand& stand, const SpeciesTable& species,
                                        std::span<const TreeSeason> seasons);

}  // namespace forest
