#pragma once

#include "validation/engine/forest_cases/plain_3pg/stand.hpp"

namespace coupling::validation::forest_cases::plain_3pg {

/// Transpiration, interception, soil evaporation and soil water of the month. Production falls with them
/// where water runs short. Rain comes first, then evapotranspiration, then what the soil cannot hold runs
/// off.
void balance_water(Stand& stand, const Inputs& inputs, const ClimateMonth& month, TranspirationModel model);

}  // namespace coupling::validation::forest_cases::plain_3pg
