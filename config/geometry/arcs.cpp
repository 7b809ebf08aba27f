#include "config/geometry/arcs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace config {

namespace {

struct Circle {
    Point2 centre;  ///< seen from the start of the arc
    double radius_m = 0.0;
    bool is_left = false;  ///< the arc turns left, with the angles
};

/// The circle through the start (the origin) and two other points; nothing where they lie on a line.
std::optional<Circle> circle_through(const Point2& middle, const Point2& end) {
    if (end == Point2{}) {
        const Point2 centre{0.5 * middle.x_m, 0.5 * middle.y_m};
        const double radius_m = std::hypot(centre.x_m, centre.y_m);
        return radius_m > 0.0 ? std::optional{Circle{centre, radius_m, true}} : std::nullopt;
    }
    const double turn = middle.x_m * end.y_m - middle.y_m * end.x_m;
    const double middle2 = middle.x_m * middle.x_m + middle.y_m * middle.y_m;
    const double end2 = end.x_m * end.x_m + end.y_m * end.y_m;
    // Flatter than what the last bits of coordinates of millions of metres can say is straight.
    constexpr double least_turn = 1e-9;
    if (!(std::abs(turn) > least_turn * std::sqrt(middle2 * end2))) {
        return std::nullopt;
    }
    const Point2 centre{0.5 * (end.y_m * middle2 - middle.y_m * end2) / turn,
                        0.5 * (middle.x_m * end2 - end.x_m * middle2) / turn};
    return Circle{centre, std::hypot(centre.x_m, centre.y_m), turn > 0.0};
}

/// Chords that an angle of a circle needs.
int chords_of(double angle_rad, double radius_m) {
    const double sine = std::sqrt(std::min(1.0, arc_tolerance_m / (2.0 * radius_m)));
    const double step_rad = std::max(4.0 * std::asin(sine), 2.0 * std::numbers::pi / most_chords);
    return std::max(1, static_cast<int>(std::ceil(angle_rad / step_rad - 1e-9)));
}

double angle_at(const Circle& circle, const Point2& point) {
    return std::atan2(point.y_m - circle.centre.y_m, point.x_m - circle.centre.x_m);
}

/// Points of the half between two points of a circle, then its end.
void add_half(const Circle& circle, const Point2& origin, const Point2& from, const Point2& to,
              const Point2& given_end, double offset, std::vector<ArcPoint>& points) {
    const double start_rad = angle_at(circle, from);
    double sweep_rad = angle_at(circle, to) - start_rad;
    if (circle.is_left != (sweep_rad > 0.0)) {
        sweep_rad += circle.is_left ? 2.0 * std::numbers::pi : -2.0 * std::numbers::pi;
    }
    const int chords = chords_of(std::abs(sweep_rad), circle.radius_m);
    for (int i = 1; i < chords; ++i) {
        const double share = static_cast<double>(i) / chords;
        const double angle_rad = start_rad + share * sweep_rad;
        points.push_back({{origin.x_m + circle.centre.x_m + circle.radius_m * std::cos(angle_rad),
                           origin.y_m + circle.centre.y_m + circle.radius_m * std::sin(angle_rad)},
                          offset + share});
    }
    points.push_back({given_end, offset + 1.0});
}

bool lies_before(const Point2& a, const Point2& b) {
    return a.x_m < b.x_m || (a.x_m == b.x_m && a.y_m < b.y_m);
}

}  // namespace

std::vector<ArcPoint> stroke_arc(const Point2& start, const Point2& middle, const Point2& end) {
    if (lies_before(end, start)) {
        std::vector<ArcPoint> points = stroke_arc(end, middle, start);
        points.pop_back();
        std::reverse(points.begin(), points.end());
        for (ArcPoint& point : points) {
            point.along = 2.0 - point.along;
        }
        points.push_back({end, 2.0});
        return points;
    }
    const Point2 to_middle{middle.x_m - start.x_m, middle.y_m - start.y_m};
    const Point2 to_end{end.x_m - start.x_m, end.y_m - start.y_m};
    const std::optional<Circle> circle = circle_through(to_middle, to_end);
    if (!circle) {
        return {{middle, 1.0}, {end, 2.0}};
    }
    std::vector<ArcPoint> points;
    add_half(*circle, start, {}, to_middle, middle, 0.0, points);
    add_half(*circle, start, to_middle, to_end, end, 1.0, points);
    return points;
}

}  // namespace config
