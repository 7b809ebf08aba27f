#pragma once

#include "forest/stand/species.hpp"

namespace forest {

/// Factor of the site on tree height at a given diameter [-]: 1.37 (1 - exp(-GDD / tau)), degree-days
/// above 5.5 degC [choice, calibrated on Guttenberg's spruce yield tables].
double site_height_factor(const HeightGrowth& law, double degree_days);

/// Height increment / diameter increment, [-]. In shade trees grow more in height. Between
/// two curves by diameter (iLand species database), straight in the light ratio [choice].
double height_diameter_ratio(const HeightGrowth& law, double dbh_cm, double light_ratio, double site_factor);

}  // namespace forest
