#pragma once

#include "forest/species.hpp"

namespace forest {

/// Deaths of trees in the shade of others.
struct SuppressionDeaths {
    double in_full_shade =
        0.01;  ///< probability a year of a very thin tree without light, most tolerant species [choice]
    double by_class = 0.005;     ///< added to it with each step of the light-response class (1-9) [choice]
    double dbh_scale_cm = 20.0;  ///< by which it has fallen to 1/e [choice]
};

/// Probability of a tree to die within a year of the shade of others [0, 1]:
/// (in_full_shade + by_class (class - 1)) (1 - L)^3 e^(-D / scale), L the light ratio, class the
/// light-response class of the species, 1 tolerant to 9 intolerant.
///
/// With canopy_death() it gives the deaths by size that unmanaged forests show: many thin and suppressed
/// trees die, few of medium size, more giants again (Holzwarth et al. 2013, J. Ecol. 101:220). Inventories
/// see deaths rise with the basal area of larger trees and fall with diameter (Guyennon et al. 2023), too.
/// Levels: [choice], with both in view.
double suppression_death(const Light& species, double dbh_cm, double light_ratio,
                         const SuppressionDeaths& law);

}  // namespace forest
