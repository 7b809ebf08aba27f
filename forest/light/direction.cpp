#include "forest/light/direction.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "config/math/elementary.hpp"

namespace forest {
namespace {

/// Arc tangent of t in [0, 1]: halving the angle twice leaves |t| < 0.2, where the series is short.
double arc_tangent(double t) {
    const double half = t / (1.0 + std::sqrt(1.0 + t * t));
    const double s = half / (1.0 + std::sqrt(1.0 + half * half));
    const double q = s * s;
    double series = 0.0;
    for (int power = 17; power >= 1; power -= 2) {
        series = 1.0 / power - q * series;
    }
    return 4.0 * s * series;
}

}  // namespace

Turn turn_of(config::Angle angle) {
    constexpr double quarter = std::numbers::pi / 2.0;
    assert(std::abs(angle.in_radians()) <= 4.0001 * quarter);
    const double quarters = std::floor(angle.in_radians() / quarter + 0.5);
    const config::SinCos rest = config::sin_cos_of(angle.in_radians() - quarters * quarter);
    switch (static_cast<int>(quarters) & 3) {
        case 0:
            return {rest.sin, rest.cos};
        case 1:
            return {rest.cos, -rest.sin};
        case 2:
            return {-rest.sin, -rest.cos};
        default:
            return {-rest.cos, rest.sin};
    }
}

config::Angle azimuth_of(double x, double y) {
    const double a = std::abs(x);
    const double b = std::abs(y);
    if (a == 0.0 && b == 0.0) {
        return {};
    }
    const double from_y = a <= b ? arc_tangent(a / b) : std::numbers::pi / 2.0 - arc_tangent(b / a);
    const double upper_half = y >= 0.0 ? from_y : std::numbers::pi - from_y;
    const double clockwise = x >= 0.0 || upper_half == 0.0 ? upper_half : 2.0 * std::numbers::pi - upper_half;
    return config::Angle::from_radians(clockwise);
}

config::Angle arc_cosine(double cosine) {
    const double c = std::clamp(cosine, -1.0, 1.0);
    return azimuth_of(std::sqrt(1.0 - c * c), c);
}

Direction direction_at(config::Angle azimuth, config::Angle elevation) {
    const Turn around = turn_of(azimuth);
    const Turn up = turn_of(elevation);
    return {up.cos * around.sin, up.cos * around.cos, up.sin};
}

Direction ground_normal(config::Angle slope, config::Angle aspect) {
    const Turn tilt = turn_of(slope);
    const Turn facing = turn_of(aspect);
    return {tilt.sin * facing.sin, tilt.sin * facing.cos, tilt.cos};
}

Direction ground_normal_of_gradient(double rise_x, double rise_y) {
    const double length = std::sqrt(1.0 + rise_x * rise_x + rise_y * rise_y);
    return {-rise_x / length, -rise_y / length, 1.0 / length};
}

}  // namespace forest
