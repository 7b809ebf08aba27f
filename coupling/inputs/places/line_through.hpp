#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "rockfall/tally/target.hpp"

namespace coupling {

/// Whether an area is a house, as far as its size says: larger ones are zones and settlements, in which there
/// is room for works.
inline bool is_house(const rockfall::Target& target) {
    constexpr double largest_m2 = 2000.0;  // [choice]
    double twice_m2 = 0.0;
    for (const std::vector<Eigen::Vector2d>& ring : target.parts) {
        double of_ring = 0.0;
        for (std::size_t i = 1; i < ring.size(); ++i) {
            const Eigen::Vector2d a = ring[i - 1] - ring.front();
            const Eigen::Vector2d b = ring[i] - ring.front();
            of_ring += a.x() * b.y() - a.y() * b.x();
        }
        twice_m2 = std::max(twice_m2, std::abs(of_ring));
    }
    return target.is_area && 0.5 * twice_m2 <= largest_m2;
}

/// Whether a line runs over a target: through the area, or across the line. Coordinates of the terrain.
inline bool runs_over(const std::vector<Eigen::Vector2d>& line_m, const rockfall::Target& target) {
    for (std::size_t i = 0; i + 1 < line_m.size(); ++i) {
        if (rockfall::first_crossing(target, line_m[i], line_m[i + 1])) {
            return true;
        }
    }
    return target.is_area && !line_m.empty() && rockfall::is_inside(target, line_m.front());
}

/// The same of an area with one closed ring: it overlaps the target.
inline bool covers_part(const std::vector<Eigen::Vector2d>& ring_m, const rockfall::Target& target) {
    if (ring_m.empty()) {
        return false;
    }
    rockfall::Target area;
    area.is_area = true;
    area.parts = {ring_m};
    area = rockfall::with_bounds(area);
    for (const std::vector<Eigen::Vector2d>& part : target.parts) {
        if (!part.empty() && rockfall::is_inside(area, part.front())) {
            return true;
        }
    }
    return runs_over(ring_m, target);
}

/// Whether a line crosses a line target, as a net that blocks a road: at a clear angle and beyond both sides
/// of it. A mark at which rocks are counted lies along a net and does not cross it so.
inline bool runs_across(const std::vector<Eigen::Vector2d>& line_m, const rockfall::Target& target) {
    constexpr double least_sine = 0.5;      // 30 degrees [choice]
    constexpr double least_beyond_m = 1.0;  // half of a narrow way [choice]
    const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return a.x() * b.y() - a.y() * b.x();
    };
    if (target.is_area || line_m.empty()) {
        return false;
    }
    for (std::size_t i = 0; i + 1 < line_m.size(); ++i) {
        const Eigen::Vector2d way_m = line_m[i + 1] - line_m[i];
        for (const std::vector<Eigen::Vector2d>& part : target.parts) {
            for (std::size_t k = 0; k + 1 < part.size(); ++k) {
                const Eigen::Vector2d edge_m = part[k + 1] - part[k];
                const double area_m2 = cross(way_m, edge_m);
                if (std::abs(area_m2) <= least_sine * way_m.norm() * edge_m.norm()) {
                    continue;
                }
                const Eigen::Vector2d to_edge_m = part[k] - line_m[i];
                const double on_line = cross(to_edge_m, edge_m) / area_m2;
                const double on_edge = cross(to_edge_m, way_m) / area_m2;
                const Eigen::Vector2d place_m = line_m[i] + on_line * way_m;
                if (on_line >= 0.0 && on_line <= 1.0 && on_edge >= 0.0 && on_edge <= 1.0 &&
                    (place_m - line_m.front()).norm() > least_beyond_m &&
                    (place_m - line_m.back()).norm() > least_beyond_m) {
                    return true;
                }
            }
        }
    }
    return false;
}

/// Those that a line or a ring (`over`, one of the two above) meets.
template <class Over>
std::vector<const rockfall::Target*> targets_under(const std::vector<Eigen::Vector2d>& line_m,
                                                   std::span<const rockfall::Target> targets,
                                                   const Over& over) {
    std::vector<const rockfall::Target*> met;
    for (const rockfall::Target& target : targets) {
        if (over(line_m, target)) {
            met.push_back(&target);
        }
    }
    return met;
}

}  // namespace coupling
