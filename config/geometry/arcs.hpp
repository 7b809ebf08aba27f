#pragma once

#include <vector>

#include "config/geometry/shape.hpp"

namespace config {

/// The most that a chord of a stroked arc lies beside it [m]: a centimetre is below what surveys of slopes
/// resolve [choice].
inline constexpr double arc_tolerance_m = 0.01;
/// The most chords of one arc [choice]. A full circle keeps the tolerance up to a radius of 2 km; of larger
/// ones the chords lie beside it by up to 5 millionths of the radius.
inline constexpr int most_chords = 1000;

/// A point of a stroked arc.
struct ArcPoint {
    Point2 place;
    /// How far along its half the point lies [0, 2]: 0 at the start, 1 at the middle point, 2 at the end.
    double along = 0.0;
};

/// Points of the arc from `start` over `middle` to `end`, without the start, with the middle and the end as
/// they were given. Where start and end are the same, the arc is the circle whose diameter ends in `middle`.
/// Three points on a line give a line. The points are the same from either end.
std::vector<ArcPoint> stroke_arc(const Point2& start, const Point2& middle, const Point2& end);

}  // namespace config
