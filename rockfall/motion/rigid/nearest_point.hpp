#pragma once

#include <Eigen/Core>

#include "rockfall/motion/rigid/ground_patch.hpp"

namespace rockfall::rigid {

/// The point of a triangle that is nearest to a place, and which of its corners it lies on: bit k for corner
/// k where the point needs it.
struct NearestPoint {
    Eigen::Vector3d point_m;
    unsigned corners;
};

/// Ericson (2005), Real-Time Collision Detection, 5.1.5.
inline NearestPoint nearest_on(const NearTriangle& t, const Eigen::Vector3d& p) {
    const Eigen::Vector3d& a = t.corners_m[0];
    const Eigen::Vector3d& b = t.corners_m[1];
    const Eigen::Vector3d& c = t.corners_m[2];
    const Eigen::Vector3d ab = b - a, ac = c - a, ap = p - a;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0.0 && d2 <= 0.0) {
        return {a, 1U};
    }
    const Eigen::Vector3d bp = p - b;
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0.0 && d4 <= d3) {
        return {b, 2U};
    }
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
        return {a + d1 / (d1 - d3) * ab, 3U};
    }
    const Eigen::Vector3d cp = p - c;
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0.0 && d5 <= d6) {
        return {c, 4U};
    }
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
        return {a + d2 / (d2 - d6) * ac, 5U};
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
        return {b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), 6U};
    }
    return {p - t.gap_m(p) * t.normal, 7U};
}

}  // namespace rockfall::rigid
