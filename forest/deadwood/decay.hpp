#pragma once

#include "forest/climate/series.hpp"
#include "forest/stand/dead_wood.hpp"
#include "forest/stand/species.hpp"

namespace forest {

/// Speed of decay relative to 10 degC and enough water [-]: exp(308.56 (1 / 56.02 - 1 / (T + 46.02))) (Lloyd
/// & Taylor 1994) times the rain's part 1 / (1 + 30 exp(-8.5 P / PET)) (iLand), at the year's mean
/// temperature [degC]. `wetness` is precipitation / potential evapotranspiration.
double decay_speed(double mean_degc, double wetness);

/// The same of a year. Potential evapotranspiration by Turc's rule for months: 0.4 T / (T + 15) (R + 50), R
/// in cal/cm2/d (Turc 1961).
double decay_speed(const ClimateYear& year);

/// Potential evapotranspiration of a year [mm] by that rule.
double potential_evapotranspiration_mm(const ClimateYear& year);

/// Rate at which lying wood and stumps lose density at 10 degC [1/year]: that of the species (Herrmann et al.
/// 2015) times 1.69.
///
/// Herrmann et al. give 0.033 for spruce, from logs of at most 36 years on sites below 10 degC. The factor is
/// fitted, before bark was counted: with it and volume_left() the logs of spruce stay 49 years by volume (53
/// without bark) and 91 by number at 3 degC; 2785 of them that were measured twice on Babia Gora stayed 47 to
/// 63 by volume and 71 to 113 by number (Holeksa et al. 2008). The same factor gives beech 32 years at 7 degC
/// until it is gone, where about 35 were found (Mueller-Using & Bartsch 2009), which was not fitted.
double lying_decay_pyear(const Deadwood& species);

/// Density after a year relative to before [-]: exp(-rate * speed).
double yearly_density_left(double rate_pyear, double speed);

/// Chance that a snag falls over within a year: its half-life divided by the speed; snags below 25 cm fall
/// twice as fast.
double fall_chance(const Deadwood& species, double dbh_cm, double speed);

/// Chance that a snag breaks within a year [choice, after 75 % broken at Gandberg in about eight years
/// (Kupferschmid et al. 2003)]: 0.1 * speed / 0.7 for stems above 25 cm, from the third year on; none broken
/// already.
double breakage_chance(const Snag& snag, int year, double speed);

/// Space between ground and underside of a log that fell with its branches or across others [m], that many
/// years after [choice]: 0.45 exp(-t / 12), 0 from 25 years on. (Fresh windthrow: 73 % of log length off
/// the ground, upper side at 0.85 m; Kupferschmid et al. 2003.)
double clearance_m(double fresh_m, double years);
inline constexpr double fresh_clearance_m = 0.45;

/// Strength of a log relative to sound wood [0, 1]: density^1.5 (1 - t / 80), the second factor at least 0
/// [choice].
double strength_share(const Log& log, int year);

/// Strength of a stump or snag [0, 1]: density^1.5; stumps of felling lose all of it between the 15th and
/// the 20th year [choice].
double strength_share(const Snag& snag, int year);

}  // namespace forest
