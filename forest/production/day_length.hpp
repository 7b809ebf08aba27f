#pragma once

#include "config/units/angle.hpp"

namespace forest {

/// Seconds from sunrise to sunset on a flat horizon in the middle of a month (1-12), as 3-PG has it (Gates
/// 1980); 0 in polar night, 86400 in polar day.
double day_length_s(config::Angle latitude, int month);

}  // namespace forest
