#include "forest/light/sun.hpp"

#include <algorithm>
#include <numbers>

namespace forest {
namespace {

constexpr double days_a_year = 365.0;

config::Angle of_the_year(double day) {
    const double turns = day / days_a_year;
    return config::Angle::from_degrees(360.0 * (turns - static_cast<int>(turns)));
}

config::Angle declination(int day) {
    return config::Angle::from_degrees(23.45 * turn_of(of_the_year(284.0 + day)).sin);
}

/// Half the length of the day as a turn of the earth, 0 in polar night and 180 degrees in polar day.
config::Angle sunset_hour_angle(Turn latitude, Turn sun) {
    // At the pole itself the cosine of the latitude is only as small as rounding leaves it.
    const double cosines = std::max(latitude.cos * sun.cos, 1e-9);
    return arc_cosine(-latitude.sin * sun.sin / cosines);
}

}  // namespace

Direction toward_sun(config::Angle latitude, int day, double solar_hour) {
    const Turn place = turn_of(latitude);
    const Turn sun = turn_of(declination(day));
    const Turn hour = turn_of(config::Angle::from_degrees(15.0 * (solar_hour - 12.0)));
    return {-sun.cos * hour.sin, sun.sin * place.cos - sun.cos * place.sin * hour.cos,
            place.sin * sun.sin + place.cos * sun.cos * hour.cos};
}

double extraterrestrial_mjpm2(config::Angle latitude, int day) {
    constexpr double day_of_solar_constant_mjpm2 = 37.6;  // 24 h of 0.0820 MJ/m2 min over pi
    const Turn place = turn_of(latitude);
    const Turn sun = turn_of(declination(day));
    const config::Angle sunset = sunset_hour_angle(place, sun);
    const double distance = 1.0 + 0.033 * turn_of(of_the_year(day)).cos;
    return day_of_solar_constant_mjpm2 * distance *
           (sunset.in_radians() * place.sin * sun.sin + place.cos * sun.cos * turn_of(sunset).sin);
}

double diffuse_share(config::Angle latitude, int day, double clearness) {
    constexpr double short_day_deg = 81.4;
    const double k = std::clamp(clearness, 0.3, 0.8);
    const config::Angle sunset = sunset_hour_angle(turn_of(latitude), turn_of(declination(day)));
    if (sunset.in_degrees() <= short_day_deg) {
        return 1.391 + k * (-3.560 + k * (4.189 - k * 2.137));
    }
    return 1.311 + k * (-3.022 + k * (3.427 - k * 1.821));
}

MonthlyRadiation split_radiation(config::Angle latitude, const std::array<double, 12>& global_mjpm2_d) {
    MonthlyRadiation split;
    for (std::size_t month = 0; month < 12; ++month) {
        const int day = mid_month_day[month];
        // In polar night there is no beam to divide by.
        const double outside_mjpm2 = std::max(extraterrestrial_mjpm2(latitude, day), 1e-6);
        const double global_mjpm2 = global_mjpm2_d[month] * days_of_month[month];
        const double share = diffuse_share(latitude, day, global_mjpm2_d[month] / outside_mjpm2);
        split.diffuse_mjpm2[month] = share * global_mjpm2;
        split.direct_mjpm2[month] = (1.0 - share) * global_mjpm2;
    }
    return split;
}

}  // namespace forest
