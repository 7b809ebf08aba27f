#pragma once

#include "forest/stand/species.hpp"

namespace forest {

/// Deaths of trees in the shade of others.
struct SuppressionDeaths {
    double in_full_shade =
        0.037;  ///< probability a year of a very thin tree without light, most tolerant species [fit]
    double by_class = 0.00056;   ///< times the cube of steps of the light-response class (1-9), added to it [fit]
    double in_full_light = 0.3;  ///< share of it that is left in full light [choice]
    double dbh_scale_cm = 6.0;   ///< by which it has fallen to 1/e [fit]
};

/// Probability of a thin tree to die within a year, most often of the shade of others [0, 1]:
/// (in_full_shade + by_class (class - 1)^3) (f + (1 - f) (1 - L)^3) e^(-D / scale), L the light ratio, f
/// in_full_light, class the light-response class of the species, 1 tolerant to 9 intolerant. Thin trees die
/// in the open, too: in inventories 0.2 to 1.4 % of those of 15 cm a year among 5 m2/ha of larger trees.
///
/// With canopy_death() it gives the deaths by size that unmanaged forests show: many thin and suppressed
/// trees die, few of medium size, more giants again (Holzwarth et al. 2013, J. Ecol. 101:220). Levels were
/// fitted to trees of 15 and 30 cm of fir, spruce, beech and larch in inventories (Guyennon et al. 2023,
/// `validation/forest_demography`), where the light-demanding larch dies four to six times as often.
double suppression_death(const Light& species, double dbh_cm, double light_ratio,
                         const SuppressionDeaths& law);

}  // namespace forest
