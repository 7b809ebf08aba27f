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
