#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "rockfall/tally/target.hpp"

namespace coupling {

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
