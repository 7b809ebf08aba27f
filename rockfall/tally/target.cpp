#include "rockfall/tally/target.hpp"

#include <algorithm>
#include <cmath>

#include "rockfall/terrain/plan.hpp"

namespace rockfall {
namespace {

double squared_distance(const Eigen::Vector2d& point, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const Eigen::Vector2d side = b - a;
    const double length2 = side.squaredNorm();
    const double share = length2 > 0.0 ? std::clamp((point - a).dot(side) / length2, 0.0, 1.0) : 0.0;
    return (point - a - share * side).squaredNorm();
}

/// Takes a share of the way that lies on it, if it is smaller.
void take_smaller(double share, std::optional<double>& first) {
    if (share >= 0.0 && share <= 1.0 && (!first || share < *first)) {
        first = share;
    }
}

/// Share of the way at which a point outside comes into a circle.
void enter_circle(const Eigen::Vector2d& from_middle, const Eigen::Vector2d& path, double radius,
                  std::optional<double>& first) {
    const double a = path.squaredNorm();
    const double b = from_middle.dot(path);
    const double root2 = b * b - a * (from_middle.squaredNorm() - radius * radius);
    if (a > 0.0 && root2 >= 0.0) {
        take_smaller((-b - std::sqrt(root2)) / a, first);
    }
}

/// The same for the strip of a side: all places beside it that are no further than the radius.
void enter_strip(const Eigen::Vector2d& from, const Eigen::Vector2d& path, const Eigen::Vector2d& a,
                 const Eigen::Vector2d& b, double radius, std::optional<double>& first) {
    const Eigen::Vector2d side = b - a;
    const double length = side.norm();
    if (length == 0.0) {
        return;
    }
    const double off = cross_in_plan(side, from - a) / length;
    const double nearer = -std::copysign(1.0, off) * cross_in_plan(side, path) / length;
    if (nearer <= 0.0) {
        return;
    }
    const double share = (std::abs(off) - radius) / nearer;
    const double along = (from + share * path - a).dot(side);
    if (along >= 0.0 && along <= length * length) {
        take_smaller(share, first);
    }
}

}  // namespace

Target with_bounds(Target target) {
    target.low_m = target.high_m = target.parts.front().front();
    for (const auto& part : target.parts) {
        for (const Eigen::Vector2d& vertex : part) {
            target.low_m = target.low_m.cwiseMin(vertex);
            target.high_m = target.high_m.cwiseMax(vertex);
        }
    }
    return target;
}

bool is_inside(const Target& target, const Eigen::Vector2d& point_m) {
    bool inside = false;
    for (const auto& ring : target.parts) {
        for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
            const Eigen::Vector2d& a = ring[i];
            const Eigen::Vector2d& b = ring[i + 1];
            if ((a.y() > point_m.y()) != (b.y() > point_m.y()) &&
                point_m.x() < a.x() + (point_m.y() - a.y()) * (b.x() - a.x()) / (b.y() - a.y())) {
                inside = !inside;
            }
        }
    }
    return inside;
}

bool is_below(const Roof& roof, const Eigen::Vector2d& place_m) {
    Target area;
    area.parts = {roof.ring_m};
    return is_inside(area, place_m);
}

std::optional<double> first_crossing(const Target& target, const Eigen::Vector2d& from_m,
                                     const Eigen::Vector2d& to_m) {
    if ((from_m.cwiseMax(to_m).array() < target.low_m.array()).any() ||
        (from_m.cwiseMin(to_m).array() > target.high_m.array()).any()) {
        return std::nullopt;
    }
    const Eigen::Vector2d path = to_m - from_m;
    std::optional<double> first;
    for (const auto& part : target.parts) {
        for (std::size_t i = 0; i + 1 < part.size(); ++i) {
            // A vertex counts to the left or on the path, never both: a path through a vertex crosses once.
            const double side_a = cross_in_plan(path, part[i] - from_m);
            const double side_b = cross_in_plan(path, part[i + 1] - from_m);
            if ((side_a >= 0.0) == (side_b >= 0.0)) {
                continue;
            }
            const Eigen::Vector2d edge = part[i + 1] - part[i];
            const double share = cross_in_plan(part[i] - from_m, edge) / cross_in_plan(path, edge);
            if (share >= 0.0 && share <= 1.0 && (!first || share < *first)) {
                first = share;
            }
        }
    }
    return first;
}

std::optional<double> first_touch(const Target& target, const Eigen::Vector2d& from_m,
                                  const Eigen::Vector2d& to_m, double radius_m) {
    const Eigen::Vector2d low = from_m.cwiseMin(to_m).array() - radius_m;
    const Eigen::Vector2d high = from_m.cwiseMax(to_m).array() + radius_m;
    const auto is_apart = [&](const Eigen::Vector2d& other_low, const Eigen::Vector2d& other_high) {
        return (high.array() < other_low.array()).any() || (low.array() > other_high.array()).any();
    };
    if (is_apart(target.low_m, target.high_m)) {
        return std::nullopt;
    }
    const Eigen::Vector2d path = to_m - from_m;
    std::optional<double> first;
    for (const auto& part : target.parts) {
        for (std::size_t i = 0; i + 1 < part.size(); ++i) {
            const Eigen::Vector2d& a = part[i];
            const Eigen::Vector2d& b = part[i + 1];
            if (is_apart(a.cwiseMin(b), a.cwiseMax(b))) {
                continue;
            }
            if (squared_distance(from_m, a, b) <= radius_m * radius_m) {
                return 0.0;
            }
            enter_strip(from_m, path, a, b, radius_m, first);
            enter_circle(from_m - a, path, radius_m, first);
            enter_circle(from_m - b, path, radius_m, first);
        }
    }
    return first;
}

}  // namespace rockfall
