#pragma once

#include <Eigen/Core>
#include <optional>

#include "config/units/angle.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace rockfall {

/// Angles under which stops are seen from above: how far rocks get, for slopes of any height. All heights are
/// those of the ground, all distances those in plan, straight from one place to the other.
struct ReachAngles {
    double fall_m = 0.0;  ///< from the ground at the start to that at the stop; negative: it stops higher
    config::Angle reach;  ///< below the horizon, from the start to the stop (Heim 1932)
    /// From the lowest cliff on the straight line to the stop, which is the top of the talus for a rock that
    /// comes down a face (Evans & Hungr 1993). None where the stop itself lies on a cliff. Where the line
    /// meets no cliff, the start stands for it. Below 0 where the stop lies higher than that cliff.
    std::optional<config::Angle> shadow;
};

/// What counts as a cliff.
struct CliffRule {
    config::Angle from = config::Angle::from_degrees(45.0);  ///< ground as steep as this (choice)
    /// The slope is that of height differences over this length along both axes, whatever the cells are, so
    /// that boulders of a fine survey are no cliffs (choice: two cells of 5 m).
    double over_m = 10.0;
};

/// Whether the ground at a place is a cliff. Where the terrain ends within that length, it is none.
bool is_cliff(const Terrain& terrain, const Eigen::Vector2d& place_m, const CliffRule& rule);

/// Nothing where one of the places lies off the terrain. The line is searched from the stop in steps of 1 m.
std::optional<ReachAngles> reach_angles(const Terrain& terrain, const Eigen::Vector2d& start_m,
                                        const Eigen::Vector2d& stop_m, const CliffRule& rule = {});

}  // namespace rockfall
