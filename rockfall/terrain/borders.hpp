#pragma once

#include <span>
#include <vector>

#include "rockfall/terrain/edges.hpp"

namespace rockfall {

/// A border once around: of the ground (counter-clockwise) or of a hole (clockwise).
struct BorderLoop {
    std::vector<TinSide> sides;
    bool around_hole = false;
};

/// The border as loops. Requires edges that neither are crowded nor flipped.
std::vector<BorderLoop> border_loops(const Tin& tin, const TinEdges& edges);

/// A straight piece between two places in plan.
struct PlanSegment {
    Eigen::Vector2d from_m;
    Eigen::Vector2d to_m;
};

/// Where two segments cross, each at a place between its ends: the pair, the smaller index first, and the
/// place. At most `most` of them.
struct PlanCrossing {
    std::size_t first;
    std::size_t second;
    Eigen::Vector2d place_m;
};
std::vector<PlanCrossing> crossings_of(std::span<const PlanSegment> segments, std::size_t most);

/// Where two segments lie over each other, within the tolerance, and run in the same sense: borders with
/// ground on the same side of both. At most `most` of them.
std::vector<PlanCrossing> laid_over_each_other(std::span<const PlanSegment> segments, double tolerance_m,
                                               std::size_t most);

}  // namespace rockfall
