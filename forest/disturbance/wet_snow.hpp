#pragma once

#include "forest/climate/series.hpp"

namespace forest {

/// Precipitation of December to February on days of -0.5 to 1.5 degC [mm]: that falls as wet snow, which
/// freezes to crowns. Sum over these months of P (Phi((1.5 - T) / 3 K) - Phi((-0.5 - T) / 3 K)), with the
/// daily scatter of the climate around the monthly mean.
///
/// Limits [choice]: the bounds, after reports of damage a little above the freezing point; the months; days
/// with precipitation have the temperatures of all days.
double wet_snow_mm(const ClimateYear& year);

/// Mean of wet_snow_mm() at 500 to 1300 m of the Kalkalpen series 1950-2010, where wet snow broke forests in
/// about one of twenty years [mm].
inline constexpr double usual_wet_snow_mm = 47.0;

/// Chance of a year in which wet snow breaks trees [0, 1]: `usual_chance` x wet snow of the year / usual wet
/// snow. Proportional [choice].
double wet_snow_chance(const ClimateYear& year, double usual_chance);

}  // namespace forest
