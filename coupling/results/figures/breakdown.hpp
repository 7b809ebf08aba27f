#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rockfall/tally/ensemble_tally.hpp"

namespace coupling {

/// Length of the stretches by which arrivals along a line are counted [m].
inline constexpr double stretch_m = 10.0;

/// What arrives on a stretch of a line.
struct Stretch {
    double from_m = 0.0;  ///< along the line in plan, from its first vertex
    double to_m = 0.0;
    Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();  ///< absolute coordinates
    rockfall::TargetTally tally;
};

/// A rock that arrives on both slopes, but at different stretches, by their numbers.
struct MovedAlong {
    std::size_t forest = 0;
    std::size_t bare = 0;
};

/// A line target by stretches; the last one ends with the line.
struct AlongLine {
    std::size_t target = 0;  ///< its number
    std::vector<Stretch> stretches;
    std::vector<MovedAlong> moved;
    [[nodiscard]] double length_m() const { return stretches.empty() ? 0.0 : stretches.back().to_m; }
};

/// Rocks that have something in common: their release zone, or their size.
struct ReleaseGroup {
    std::uint32_t zone = 0;      ///< of a group by zone
    double smallest_m = 0.0;     ///< of a group by size: diameters in it
    double largest_m = 0.0;      ///< equal to the smallest: one diameter
    std::uint64_t released = 0;  ///< rocks
    std::vector<rockfall::TargetTally> targets;
};

/// The arrivals of a run by place, release zone and block size.
struct Breakdown {
    bool is_known = false;  ///< false: no targets, or the run keeps no arrivals (output.arrivals = no)
    std::vector<AlongLine> lines;
    std::vector<ReleaseGroup> zones;  ///< by number; empty for more than `most_targets_of_groups` targets
    std::vector<ReleaseGroup> sizes;  ///< rising; empty where all rocks have one size
};

/// Zones and sizes are counted for at most so many targets [choice]: for a village the tables by target say
/// enough.
inline constexpr std::size_t most_targets_of_groups = 50;

}  // namespace coupling
