#pragma once

namespace forest {

// Snow in months instead of days, for days that scatter normally around the month's mean by 4 K [choice,
// after the daily rule of iLand: snow below 0.5 degC, melt of 0.7 mm a degree-day].

/// Share of a month's precipitation that falls as snow [-].
double snow_share(double tave_degc);

/// Snow that a month could melt [mm].
double melt_capacity_mm(double tave_degc, double days);

}  // namespace forest
