#include "forest/production/day_length.hpp"

#include <cmath>
#include <numbers>

#include "config/math/elementary.hpp"
#include "forest/climate/calendar.hpp"

namespace forest {

namespace {

/// Angle between 0 and pi whose cosine is c, |c| <= 1. Newton's steps on the sine keep the library's acos,
/// which differs between machines, out of the forest; six of them reach the last digits, as the angle is
/// below 45 degrees.
double hour_angle_of(double c) {
    const double sine_of_half = std::sqrt(0.5 * (1.0 - std::abs(c)));
    double half = sine_of_half;
    for (int step = 0; step < 6; ++step) {
        const config::SinCos at = config::sin_cos_of(half);
        half -= (at.sin - sine_of_half) / at.cos;
    }
    return c >= 0.0 ? 2.0 * half : std::numbers::pi - 2.0 * half;
}

/// Sine of the sun's declination on a day of the year.
double sine_of_declination(int day) {
    const double angle_rad = 0.0172 * (day - 80.0);
    // The series wants an angle of at most a right angle; that of the second half of the year mirrors the
    // first.
    const bool second_half = angle_rad > 0.5 * std::numbers::pi;
    return 0.4 * config::sin_cos_of(second_half ? std::numbers::pi - angle_rad : angle_rad).sin;
}

}  // namespace

double day_length_s(config::Angle latitude, int month) {
    const config::SinCos at = config::sin_cos_of(latitude.in_radians());
    const double s = sine_of_declination(middle_day(month));
    const double cos_sunset = -s * at.sin / (at.cos * std::sqrt(1.0 - s * s));
    if (cos_sunset >= 1.0) {
        return 0.0;
    }
    if (cos_sunset <= -1.0) {
        return seconds_per_day;
    }
    return seconds_per_day * hour_angle_of(cos_sunset) / std::numbers::pi;
}

}  // namespace forest
