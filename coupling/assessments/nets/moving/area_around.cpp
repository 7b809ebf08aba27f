#include "coupling/assessments/nets/moving/area_around.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coupling::moving {
namespace {

constexpr int corners_around = 16;
/// What is nearer than this counts as inside: no rounding keeps a piece out.
constexpr double slack_m = 0.01;

/// Twice the area of the triangle a, b, p: above 0 where p lies left of the way from a to b.
double left_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
    return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

/// Counter-clockwise (Andrew 1979).
PlanLine convex_hull(PlanLine points) {
    std::sort(points.begin(), points.end(), [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    });
    PlanLine hull;
    const auto add = [&](const Eigen::Vector2d& point, std::size_t least) {
        while (hull.size() >= least + 2 && left_of(hull[hull.size() - 2], hull.back(), point) <= 0.0) {
            hull.pop_back();
        }
        hull.push_back(point);
    };
    for (const Eigen::Vector2d& point : points) {
        add(point, 0);
    }
    const std::size_t lower = hull.size() - 1;
    for (auto point = points.rbegin() + 1; point != points.rend(); ++point) {
        add(*point, lower);
    }
    hull.pop_back();  // the first once more
    return hull;
}

/// How far a point lies inside of a side, in metres; below 0 outside.
double inside_by_m(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
    return left_of(a, b, p) / (b - a).norm();
}

}  // namespace

AreaAround::AreaAround(const PlanLine& line, double width_m) : low_m_{line.front()}, high_m_{line.front()} {
    // The sides of the polygon, not its corners, are so far away.
    const double corner_m = width_m / std::cos(std::numbers::pi / corners_around);
    PlanLine points;
    for (const Eigen::Vector2d& corner : line) {
        for (int i = 0; i < corners_around; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / corners_around;
            points.emplace_back(corner + corner_m * Eigen::Vector2d{std::cos(angle), std::sin(angle)});
        }
    }
    corners_m_ = convex_hull(std::move(points));
    for (const Eigen::Vector2d& corner : corners_m_) {
        low_m_ = low_m_.cwiseMin(corner);
        high_m_ = high_m_.cwiseMax(corner);
    }
}

bool AreaAround::touches(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) const {
    if (std::max(from_m.x(), to_m.x()) < low_m_.x() - slack_m ||
        std::min(from_m.x(), to_m.x()) > high_m_.x() + slack_m ||
        std::max(from_m.y(), to_m.y()) < low_m_.y() - slack_m ||
        std::min(from_m.y(), to_m.y()) > high_m_.y() + slack_m) {
        return false;
    }
    double first = 0.0;  // of the way
    double last = 1.0;
    for (std::size_t i = 0; i < corners_m_.size(); ++i) {
        const Eigen::Vector2d& a = corners_m_[i];
        const Eigen::Vector2d& b = corners_m_[(i + 1) % corners_m_.size()];
        const double start_m = inside_by_m(a, b, from_m) + slack_m;
        const double end_m = inside_by_m(a, b, to_m) + slack_m;
        if (start_m < 0.0 && end_m < 0.0) {
            return false;
        }
        if (start_m < 0.0) {
            first = std::max(first, start_m / (start_m - end_m));
        } else if (end_m < 0.0) {
            last = std::min(last, start_m / (start_m - end_m));
        }
    }
    return first <= last;
}

bool AreaAround::may_touch(std::span<const Eigen::Vector2d, 3> triangle_m) const {
    const Eigen::Vector2d low_m = triangle_m[0].cwiseMin(triangle_m[1]).cwiseMin(triangle_m[2]);
    const Eigen::Vector2d high_m = triangle_m[0].cwiseMax(triangle_m[1]).cwiseMax(triangle_m[2]);
    if ((high_m.array() < low_m_.array() - slack_m).any() ||
        (low_m.array() > high_m_.array() + slack_m).any()) {
        return false;
    }
    for (std::size_t i = 0; i < corners_m_.size(); ++i) {
        const Eigen::Vector2d& a = corners_m_[i];
        const Eigen::Vector2d& b = corners_m_[(i + 1) % corners_m_.size()];
        if (std::all_of(triangle_m.begin(), triangle_m.end(),
                        [&](const Eigen::Vector2d& p) { return inside_by_m(a, b, p) < -slack_m; })) {
            return false;
        }
    }
    return true;
}

}  // namespace coupling::moving
