#pragma once

#include "config/math/elementary.hpp"

namespace forest {

/// Saturation vapour pressure over water [kPa] (Tetens 1930, as in 3-PG).
inline double saturation_pressure_kpa(double degc) {
    return 0.61078 * config::exp_of(17.269 * degc / (237.3 + degc));
}

/// Daytime vapour pressure deficit [kPa] from a month's mean minimum and maximum temperature: the air is
/// taken to be saturated at the minimum (Landsberg & Waring 1997).
inline double vpd_from_temperatures_kpa(double tmin_degc, double tmax_degc) {
    return 0.5 * (saturation_pressure_kpa(tmax_degc) - saturation_pressure_kpa(tmin_degc));
}

}  // namespace forest
