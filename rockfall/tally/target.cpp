#include "rockfall/tally/target.hpp"

namespace rockfall {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
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
            const double side_a = cross(path, part[i] - from_m);
            const double side_b = cross(path, part[i + 1] - from_m);
            if ((side_a >= 0.0) == (side_b >= 0.0)) {
                continue;
            }
            const Eigen::Vector2d edge = part[i + 1] - part[i];
            const double share = cross(part[i] - from_m, edge) / cross(path, edge);
            if (share >= 0.0 && share <= 1.0 && (!first || share < *first)) {
                first = share;
            }
        }
    }
    return first;
}

}  // namespace rockfall
