#pragma once

#include <array>

#include "config/units/angle.hpp"
#include "forest/climate/series.hpp"

namespace forest {

/// Days of a year for beetles, made of months: values stand in the middle of a month and change linearly to
/// the next as half a sine wave.
struct BeetleDays {
    std::array<double, 365> mean_degc{};
    std::array<double, 365> max_degc{};
    std::array<double, 365> radiation_whpm2{};  ///< of the day, on flat ground
    std::array<double, 365> day_length_h{};
};

BeetleDays beetle_days(const ClimateYear& year, config::Angle latitude);

/// Generations that the beetles of a patch complete in a year.
struct Broods {
    int generations = 0;  ///< broods finished or at least 60 % of the way
    bool sister = false;  ///< a sister brood of one of them got as far
    friend bool operator==(const Broods&, const Broods&) = default;
};

/// Broods of Ips typographus after PHENIPS, as in iLand. They fly once the degree-days of daily maxima above
/// 8.3 degC since 1 April have reached 140, on the first day above 16.5 degC. A brood takes 557 degree-days
/// above 8.3 degC of the bark, -0.173 + 0.0008518 R light + 1.054 T, cut at 38.9 degC; a sister brood begins
/// half-way through. None begins once days are shorter than 14.5 hours again.
///
/// `ground_light` is the share of light that gets through the crowns [0, 1]; the source takes
/// exp(-0.5 leaf area index) for it.
Broods broods_of(const BeetleDays& days, double ground_light);

/// Days of a year with a minimum below -15 degC to be expected of its months.
double cold_days(const ClimateYear& year);

/// Chance that the beetles of a patch survive a winter: 0.6 exp(-0.1005 cold days) (iLand).
double winter_survival(double cold_days);

}  // namespace forest
