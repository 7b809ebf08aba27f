#include "forest/deaths/suppression_deaths.hpp"

#include "config/math/elementary.hpp"

namespace forest {

double suppression_death(const Light& species, double dbh_cm, double light_ratio,
                         const SuppressionDeaths& law) {
    const double shade = 1.0 - light_ratio;
    const double steps = species.response_class - 1.0;
    const double level = law.in_full_shade + law.by_class * steps * steps * steps;
    const double of_light = law.in_full_light + (1.0 - law.in_full_light) * shade * shade * shade;
    return level * of_light * config::exp_of(-dbh_cm / law.dbh_scale_cm);
}

}  // namespace forest
