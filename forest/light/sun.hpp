#pragma once

#include <array>

#include "config/units/angle.hpp"
#include "forest/light/direction.hpp"

namespace forest {

/// The day that stands for its month, and the days a month has.
inline constexpr std::array<int, 12> mid_month_day{15, 46, 74, 105, 135, 166, 196, 227, 258, 288, 319, 349};
inline constexpr std::array<int, 12> days_of_month{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};

/// Where the sun stands, x east and y north; below the horizon where z < 0.
///
/// Declination after Cooper (1969): 23.45 deg sin(2 pi (284 + day) / 365), within half a degree.
/// `day` counts from 1 January = 1, `solar_hour` in [0, 24] is 12 when the sun stands highest.
[[nodiscard]] Direction toward_sun(config::Angle latitude, int day, double solar_hour);

/// Solar energy of one day on a horizontal plane outside the atmosphere [MJ/m2], as in FAO-56 Eq. 21;
/// latitudes in
/// [-90, 90] degrees with polar day and night.
[[nodiscard]] double extraterrestrial_mjpm2(config::Angle latitude, int day);

/// Solar energy of each month on a horizontal plane, split into the sun's beam and the light of the sky
/// [MJ/m2 a month].
struct MonthlyRadiation {
    std::array<double, 12> direct_mjpm2{};
    std::array<double, 12> diffuse_mjpm2{};
};

/// Splits monthly means of daily global radiation [MJ/m2 d] by the diffuse share of their clearness, the
/// correlation of Erbs, Klein & Duffie (1982) for monthly means, clearness cut to [0.3, 0.8].
[[nodiscard]] MonthlyRadiation split_radiation(config::Angle latitude,
                                               const std::array<double, 12>& global_mjpm2_d);

/// Share of diffuse in global radiation [-] of the month around `day`, given clearness = global /
/// extraterrestrial.
[[nodiscard]] double diffuse_share(config::Angle latitude, int day, double clearness);

}  // namespace forest
