#pragma once

#include "forest/stand/species.hpp"

namespace forest {

/// Greatest height of a species at a place [m]: its greatest height anywhere times 1 - exp(-GDD / (1.75
/// tau)), with the mean degree-days above 5.5 degC of many years [choice]. Requires degree-days >= 0.
double site_height_m(const HeightGrowth& law, double usual_degree_days);

/// What is left of height growth at a given diameter growth [0, 1]: 1 - (H / Hsite)^4, 0 beyond [choice].
double height_room(double height_m, double site_height_m);

/// Degree-days of a usual year after one more of them: a mean over about 30 years that forgets the older
/// ones.
struct UsualWarmth {
    double degree_days = 0.0;
    int years = 0;  ///< that it is made of, at most 30
};
UsualWarmth after_year(UsualWarmth usual, double degree_days);

}  // namespace forest
