#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "config/units/constants.hpp"
#include "rockfall/motion/rigid/contact_search.hpp"
#include "rockfall/motion/rigid/nearest_point.hpp"

namespace rockfall::rigid {
namespace {

using config::gravity_mps2;
using Eigen::Vector3d;

constexpr double never_s = std::numeric_limits<double>::infinity();

/// Where edges of the ground are near, a free block moves by at least this share of its radius before it is
/// looked at again: contacts there are found from gaps below 0 and then located.
constexpr double least_move = 0.02;

/// When a gap that changes at this rate can be closed, accelerated by at most `a_mps2`.
double closing_time_s(double gap_m, double rate_mps, double a_mps2) {
    const double open_m = std::max(0.0, gap_m);
    return (rate_mps + std::sqrt(rate_mps * rate_mps + 2.0 * a_mps2 * open_m)) / a_mps2;
}

double sphere_free_time_s(const GroundPatch& patch, const PosedBlock& block, const FreeMotion& motion) {
    // The distance from a triangle is convex along a straight line, so gravity alone bends it downwards.
    double time_s = never_s;
    for (const NearTriangle& triangle : patch.triangles()) {
        const Vector3d off_m = block.centre_m - nearest_on(triangle, block.centre_m).point_m;
        const double distance_m = off_m.norm();
        if (distance_m > 0.0) {
            time_s =
                std::min(time_s, closing_time_s(distance_m - block.solid->bounding_radius_m,
                                                motion.velocity_mps.dot(off_m) / distance_m, gravity_mps2));
        }
    }
    return time_s;
}

/// Of all vertices over the plane through a ridge with this normal.
double over_plane_s(const PosedBlock& block, const FreeMotion& motion, double acceleration_mps2,
                    const Vector3d& normal, const Vector3d& point_m) {
    double time_s = never_s;
    for (const Vector3d& vertex_m : block.vertices_m) {
        const double gap_m = normal.dot(vertex_m - point_m);
        if (gap_m <= 0.0) {
            return 0.0;
        }
        const Vector3d moves_mps = motion.velocity_mps + motion.spin_radps.cross(vertex_m - block.centre_m);
        time_s = std::min(time_s, closing_time_s(gap_m, normal.dot(moves_mps), acceleration_mps2));
    }
    return time_s;
}

double ridges_free_time_s(const GroundPatch& patch, const PosedBlock& block, const FreeMotion& motion,
                          double acceleration_mps2, double until_s) {
    const double radius_m = block.solid->bounding_radius_m;
    const double fastest_mps = motion.velocity_mps.norm() + motion.largest_spin_radps * radius_m;
    const double least_s = least_move * radius_m / (fastest_mps + 1e-3);
    for (const NearRidge& ridge : patch.ridges()) {
        const Vector3d to_centre_m = block.centre_m - ridge.from_m;
        const double share =
            std::clamp(ridge.along_m.dot(to_centre_m) / ridge.along_m.squaredNorm(), 0.0, 1.0);
        const Vector3d off_m = to_centre_m - share * ridge.along_m;
        const double distance_m = off_m.norm();
        double time_s = least_s;
        if (distance_m > radius_m) {
            time_s =
                std::max(time_s, closing_time_s(distance_m - radius_m,
                                                motion.velocity_mps.dot(off_m) / distance_m, gravity_mps2));
        }
        for (const Vector3d& normal : {Vector3d{(ridge.left_normal + ridge.right_normal).normalized()},
                                       ridge.left_normal, ridge.right_normal}) {
            if (time_s >= until_s) {
                break;
            }
            time_s = std::max(time_s, over_plane_s(block, motion, acceleration_mps2, normal, ridge.from_m));
        }
        until_s = std::min(until_s, time_s);
    }
    return until_s;
}

double peaks_free_time_s(const GroundPatch& patch, const PosedBlock& block, const FreeMotion& motion,
                         double acceleration_mps2) {
    const solids::Hull& hull = block.solid->hull;
    const double radius_m = block.solid->bounding_radius_m;
    const double bound_mps2 =
        acceleration_mps2 + 2.0 * motion.largest_spin_radps * motion.velocity_mps.norm();
    double time_s = never_s;
    for (const NearPeak& peak : patch.peaks()) {
        const Vector3d off_m = peak.point_m - block.centre_m;
        const double distance_m = off_m.norm();
        if (distance_m > radius_m) {
            const double rate_mps = -motion.velocity_mps.dot(off_m) / distance_m;
            time_s = std::min(time_s, closing_time_s(distance_m - radius_m, rate_mps, gravity_mps2));
            continue;
        }
        const Vector3d local_m = block.turn.transpose() * off_m;
        double gap_m = -never_s;
        Vector3d normal = Vector3d::UnitZ();
        for (const solids::Face& face : hull.faces) {
            const double height_m = face.normal.dot(local_m) - face.offset_m;
            if (height_m > gap_m) {
                gap_m = height_m;
                normal = face.normal;
            }
        }
        if (gap_m > 0.0) {
            const Vector3d moves_mps = motion.velocity_mps + motion.spin_radps.cross(off_m);
            time_s =
                std::min(time_s, closing_time_s(gap_m, -(block.turn * normal).dot(moves_mps), bound_mps2));
        }
    }
    return time_s;
}

}  // namespace

double free_time_s(const GroundPatch& patch, const PosedBlock& block, const FreeMotion& motion) {
    if (block.is_sphere()) {
        return sphere_free_time_s(patch, block, motion);
    }
    // Of a turning point: centripetal, and as much again for the change of the spin of a tumbling block.
    const double radius_m = block.solid->bounding_radius_m;
    const double acceleration_mps2 =
        gravity_mps2 + 2.0 * motion.largest_spin_radps * motion.largest_spin_radps * radius_m;
    const double fastest_mps = motion.velocity_mps.norm() + motion.largest_spin_radps * radius_m;
    const double least_s = least_move * radius_m / (fastest_mps + 1e-3);
    double time_s = never_s;
    for (const NearTriangle& triangle : patch.triangles()) {
        if (triangle.gap_m(block.centre_m) > 3.0 * radius_m) {
            const double rate_mps = triangle.normal.dot(motion.velocity_mps);
            time_s = std::min(
                time_s, closing_time_s(triangle.gap_m(block.centre_m) - radius_m, rate_mps, gravity_mps2));
            continue;
        }
        for (const Vector3d& vertex_m : block.vertices_m) {
            const double outside_m = triangle.outside_m(vertex_m);
            const double arrives_s = outside_m > 0.0 ? std::max(least_s, outside_m / fastest_mps) : 0.0;
            if (arrives_s >= time_s) {
                continue;
            }
            const Vector3d moves_mps =
                motion.velocity_mps + motion.spin_radps.cross(vertex_m - block.centre_m);
            const double closes_s =
                closing_time_s(triangle.gap_m(vertex_m), triangle.normal.dot(moves_mps), acceleration_mps2);
            time_s = std::min(time_s, std::max(arrives_s, closes_s));
        }
    }
    if (!patch.peaks().empty()) {
        time_s = std::min(time_s, peaks_free_time_s(patch, block, motion, acceleration_mps2));
        time_s = ridges_free_time_s(patch, block, motion, acceleration_mps2, time_s);
    }
    return time_s;
}

double first_possible_touch_s(const NearTriangle& triangle, const BallFlight& ball, double from_s,
                              double until_s) {
    // When the centre is within the box around the triangle, widened by the radius, in plan.
    double begin_s = from_s, end_s = until_s;
    for (int axis = 0; axis < 2; ++axis) {
        double low_m = triangle.corners_m[0][axis], high_m = low_m;
        for (int k = 1; k < 3; ++k) {
            low_m = std::min(low_m, triangle.corners_m[k][axis]);
            high_m = std::max(high_m, triangle.corners_m[k][axis]);
        }
        low_m -= ball.radius_m + ball.centre_m[axis];
        high_m += ball.radius_m - ball.centre_m[axis];
        const double v = ball.velocity_mps[axis];
        if (v == 0.0) {
            if (low_m > 0.0 || high_m < 0.0) {
                return never_s;
            }
            continue;
        }
        begin_s = std::max(begin_s, std::min(low_m / v, high_m / v));
        end_s = std::min(end_s, std::max(low_m / v, high_m / v));
    }
    if (begin_s > end_s) {
        return never_s;
    }
    const double height_m = triangle.gap_m(ball.centre_m) - ball.radius_m;
    const double rate_mps = triangle.normal.dot(ball.velocity_mps);
    const double bend_mps2 = 0.5 * gravity_mps2 * triangle.normal.z();
    const auto gap_m = [&](double t) { return height_m + t * (rate_mps - bend_mps2 * t); };
    if (gap_m(begin_s) <= 0.0) {
        return begin_s;
    }
    if (gap_m(end_s) > 0.0) {
        return never_s;
    }
    const double root = std::sqrt(std::max(0.0, rate_mps * rate_mps + 4.0 * bend_mps2 * height_m));
    const double time_s =
        rate_mps >= 0.0 ? (rate_mps + root) / (2.0 * bend_mps2) : 2.0 * height_m / (root - rate_mps);
    return std::clamp(time_s, begin_s, end_s);
}

}  // namespace rockfall::rigid
