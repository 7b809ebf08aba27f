#pragma once

#include "forest/check_mode/stand.hpp"

namespace forest::check_mode {

/// Transpiration, interception, soil evaporation and soil water of the month. Production falls with them
/// where water runs short. Rain comes first, then evapotranspiration, then what the soil cannot hold runs
/// off.
void balance_water(Stand& stand, const Inputs& inputs, const ClimateMonth& month, TranspirationModel model);

}  // namespace forest::check_mode
