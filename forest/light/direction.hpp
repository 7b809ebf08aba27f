#pragma once

#include <array>

#include "config/units/angle.hpp"

namespace forest {

/// A unit vector towards the sky or along the normal of the ground, in the axes of the grid: x to the right
/// (east where the grid points north), y up the page, z up.
struct Direction {
    double x = 0.0;
    double y = 0.0;
    double z = 1.0;
};

[[nodiscard]] inline double dot(const Direction& a, const Direction& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Sine and cosine of an angle of at most a full circle either way, absolute error below 1e-10.
///
/// Here and below the elementary functions are those of config/math, so that the light on a slope has the
/// same bits on every processor.
struct Turn {
    double sin = 0.0;
    double cos = 1.0;
};
[[nodiscard]] Turn turn_of(config::Angle angle);

/// Angle from the y axis clockwise to (x, y), in [0, 360) degrees; 0 for (0, 0). Absolute error below 1e-10
/// rad.
[[nodiscard]] config::Angle azimuth_of(double x, double y);

/// Angle whose cosine is given, in [0, 180] degrees; cosines beyond 1 are taken as 1.
[[nodiscard]] config::Angle arc_cosine(double cosine);

/// The direction at an azimuth (clockwise from the y axis) and a height above the horizontal.
[[nodiscard]] Direction direction_at(config::Angle azimuth, config::Angle elevation);

/// Normal of ground that is inclined by `slope` and faces `aspect` (downslope direction, clockwise from the y
/// axis).
[[nodiscard]] Direction ground_normal(config::Angle slope, config::Angle aspect);

/// Normal of ground that rises by the two gradients [-] along x and y.
[[nodiscard]] Direction ground_normal_of_gradient(double rise_x, double rise_y);

}  // namespace forest
