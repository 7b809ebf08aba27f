#include "config/geometry/arcs.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace config::arcs_test {
namespace {

double distance_m(const Point2& a, const Point2& b) {
    return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
}

TEST(StrokeArc, KeepsTheGivenPoints) {
    const Point2 middle{3, 1.25};
    const Point2 end{5, -2};
    const auto points = stroke_arc({1, 1}, middle, end);
    EXPECT_EQ(points.back().place, end);
    EXPECT_EQ(points.back().along, 2.0);
    EXPECT_EQ(std::count_if(points.begin(), points.end(), [&](const auto& p) { return p.place == middle; }),
              1);
}

TEST(StrokeArc, OfThreePointsOnALineIsThatLine) {
    const auto points = stroke_arc({0, 0}, {1, 2}, {2, 4});
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points[0].place, (Point2{1, 2}));
    EXPECT_EQ(stroke_arc({3, 3}, {3, 3}, {3, 3}).size(), 2U);
}

// Anywhere on the map, of any size and turn: the points lie on the circle, the chords within the tolerance.
RC_GTEST_PROP(StrokeArc, StaysOnTheCircle, ()) {
    const double x_m = *rc::gen::inRange(-3'000'000, 3'000'000);
    const double y_m = *rc::gen::inRange(-3'000'000, 3'000'000);
    const double radius_m = *rc::gen::inRange(1, 200'000) / 100.0;
    const double first_rad = *rc::gen::inRange(0, 628) / 100.0;
    const double sweep_rad = *rc::gen::inRange(10, 620) / 100.0 * (*rc::gen::arbitrary<bool>() ? 1 : -1);
    const auto at = [&](double angle) {
        return Point2{x_m + radius_m * std::cos(angle), y_m + radius_m * std::sin(angle)};
    };
    const Point2 start = at(first_rad);
    const Point2 end = at(first_rad + sweep_rad);
    const auto points = stroke_arc(start, at(first_rad + 0.5 * sweep_rad), end);
    // The given points are rounded to some 5e-10 m, which a short arc magnifies by up to 8 r^2 / (arc)^2.
    const double slack_m = 5e-9 * std::max(1.0, 8.0 / (sweep_rad * sweep_rad));
    Point2 before = start;
    for (const ArcPoint& point : points) {
        RC_ASSERT(std::abs(distance_m(point.place, {x_m, y_m}) - radius_m) <= slack_m);
        const Point2 between{0.5 * (before.x_m + point.place.x_m), 0.5 * (before.y_m + point.place.y_m)};
        RC_ASSERT(radius_m - distance_m(between, {x_m, y_m}) <= arc_tolerance_m + slack_m);
        before = point.place;
    }
    RC_ASSERT(points.size() <= most_chords + 2U);
    // Neighbours share the border: the same points from the other end.
    const auto back = stroke_arc(end, at(first_rad + 0.5 * sweep_rad), start);
    RC_ASSERT(back.size() == points.size());
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        RC_ASSERT(back[back.size() - 2 - i].place == points[i].place);
    }
}

}  // namespace
}  // namespace config::arcs_test
