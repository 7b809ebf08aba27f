#pragma once

#include <Eigen/Core>

namespace rockfall {

/// The cross product of two ways in plan (m2): above 0 where `b` turns left of `a`.
inline double cross_in_plan(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

}  // namespace rockfall
