#pragma once

namespace forest {

/// Density of the standard normal distribution.
double normal_density(double z);

/// Probability that a standard normal value is below z, error below 1e-11 (Hart 1968, as in West 2005,
/// Wilmott 70-76), the same on every machine.
double normal_probability(double z);

/// Days and nights of a month scatter around their mean with about this deviation [K]; it makes the
/// degree-days and frost days of the Kalkalpen series out of their monthly means to 2.5 degree-days and 1.1
/// days.
inline constexpr double daily_scatter_k = 3.0;

/// Mean of what daily temperatures have above a base, for a monthly mean and a normal scatter of days [K].
double mean_above(double mean_degc, double base_degc, double scatter_k);

}  // namespace forest
