#pragma once

#include <string>

#include "config/table/table.hpp"
#include "config/units/angle.hpp"

namespace coupling::climate {

/// Makes rad_mj_m2_d of a monthly table from sunshine_h (hours of a month) where it has no radiation:
/// Angstrom (1924) with the factors of FAO-56 (Allen et al. 1998, equation 35: 0.25 + 0.50 n / N of what
/// arrives outside the atmosphere). Returns what is to be warned of; "" where nothing was made. Rows without
/// a number of hours get none.
std::string take_sunshine(config::Table& table, config::Angle latitude);

}  // namespace coupling::climate
