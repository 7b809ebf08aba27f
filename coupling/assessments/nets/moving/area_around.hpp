#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "coupling/inputs/nets/net_lines.hpp"

namespace coupling::moving {

/// A convex area in plan that holds all places no farther than a width from a line: the convex hull of
/// regular polygons of 16 corners around its corners.
class AreaAround {
public:
    /// Requires a corner or more and a width above 0.
    AreaAround(const PlanLine& line, double width_m);

    /// Counter-clockwise.
    [[nodiscard]] const PlanLine& corners_m() const { return corners_m_; }
    [[nodiscard]] const Eigen::Vector2d& low_m() const { return low_m_; }
    [[nodiscard]] const Eigen::Vector2d& high_m() const { return high_m_; }
    /// Whether a straight way has a part in the area or within a centimetre of it.
    [[nodiscard]] bool touches(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) const;
    /// False only for a triangle that lies wholly beyond one side of the area, or beyond the box around it,
    /// by more than a centimetre.
    [[nodiscard]] bool may_touch(std::span<const Eigen::Vector2d, 3> triangle_m) const;

private:
    PlanLine corners_m_;
    Eigen::Vector2d low_m_;
    Eigen::Vector2d high_m_;
};

}  // namespace coupling::moving
