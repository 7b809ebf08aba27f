#include "rockfall/motion/pir3d/sliding.hpp"

#include <algorithm>
#include <cmath>

#include "config/units/constants.hpp"
#include "rockfall/laws/leaving.hpp"

namespace rockfall::pir3d {
namespace {

using config::gravity_mps2;

constexpr double longest_step_s = 0.25;
constexpr double largest_turn_rad = 0.05;
constexpr double edge_tolerance_m = 1e-6;

Eigen::Vector3d gravity_along(const Eigen::Vector3d& normal) {
    return -gravity_mps2 * (Eigen::Vector3d::UnitZ() - normal.z() * normal);
}

/// Unit vector of a motion; of one that stands, `otherwise`.
Eigen::Vector3d direction_of(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& otherwise) {
    const double speed_mps = velocity_mps.norm();
    return speed_mps < standing_mps ? otherwise : Eigen::Vector3d{velocity_mps / speed_mps};
}

Eigen::Vector3d fall_line(const Eigen::Vector3d& normal) {
    return gravity_along(normal).normalized();  // zero on level ground
}

/// Longest step over which friction keeps its direction well enough, and up to a standstill at most.
double longest_s(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& normal, double friction) {
    const double speed_mps = velocity_mps.norm();
    if (speed_mps < standing_mps) {
        return longest_step_s;
    }
    const Eigen::Vector3d direction = velocity_mps / speed_mps;
    const Eigen::Vector3d acceleration = sliding_acceleration(normal, direction, friction);
    const double along = acceleration.dot(direction);
    const double across = (acceleration - along * direction).norm();
    const double until_rest_s = along < 0.0 ? speed_mps / -along : 2.0 * longest_step_s;
    if (across < 1e-9 * gravity_mps2) {
        return std::min(longest_step_s, until_rest_s);  // straight, and exact whatever its length
    }
    const double by_turn_s = std::min(longest_step_s, largest_turn_rad * speed_mps / across);
    // Near rest friction turns the motion into the fall line at the rate k g n_z / v, faster than any fixed
    // step can follow: a step of more than 2.8 of its times would never settle.
    const double turning_time_s = speed_mps / (friction * gravity_mps2 * normal.z());
    return std::max(std::min(by_turn_s, 0.5 * until_rest_s),
                    std::min({shortest_rolling_piece_s, until_rest_s, turning_time_s}));
}

SlidingPiece piece_of(const PointState& start, const SlidingStep& step, std::uint32_t triangle) {
    const double h = step.duration_s;
    SlidingPiece piece{{start.position_m, start.velocity_mps,
                        2.0 / (h * h) * (step.end.position_m - start.position_m - h * start.velocity_mps), h,
                        RollingEnd::piece, triangle, false, true},
                       (step.end.velocity_mps - start.velocity_mps) / h};
    return piece;
}

}  // namespace

Eigen::Vector3d sliding_acceleration(const Eigen::Vector3d& normal, const Eigen::Vector3d& direction,
                                     double friction) {
    return gravity_along(normal) - friction * gravity_mps2 * normal.z() * direction;
}

SlidingStep sliding_step(const PointState& start, const Eigen::Vector3d& normal, double friction,
                         double longest_s, double tolerance_m) {
    // A stage of the step that comes to rest keeps the friction of the motion that led there.
    const Eigen::Vector3d first = direction_of(start.velocity_mps, fall_line(normal));
    const auto acceleration = [&](const Eigen::Vector3d&, const Eigen::Vector3d& velocity_mps) {
        return sliding_acceleration(normal, direction_of(velocity_mps, first), friction);
    };
    constexpr int most_tries = 30;
    double step_s = longest_s;
    NystromStep step = nystrom_step(start, step_s, acceleration);
    for (int i = 0; i < most_tries && step.error_m > tolerance_m; ++i) {
        const double ratio = tolerance_m / (2.0 * step.error_m);
        step_s *= std::clamp(std::sqrt(std::sqrt(ratio)), 0.25, 0.9);
        step = nystrom_step(start, step_s, acceleration);
    }
    return {step.end, step_s};
}

SlidingPiece slide(const Terrain& terrain, std::uint32_t triangle, const Face& face,
                   const Eigen::Vector3d& start_m, const Eigen::Vector3d& velocity_mps, double friction,
                   double tolerance_m) {
    const Eigen::Vector3d& normal = face.normal;
    const PointState start{start_m, velocity_mps};
    if (velocity_mps.norm() < standing_mps && face.plane.gradient.norm() <= friction) {
        return {{start_m, velocity_mps, Eigen::Vector3d::Zero(), 0.0, RollingEnd::standstill, triangle, false,
                 true},
                Eigen::Vector3d::Zero()};
    }
    const double allowed_s = longest_s(velocity_mps, normal, friction);
    SlidingPiece piece =
        piece_of(start, sliding_step(start, normal, friction, allowed_s, tolerance_m), triangle);
    Leaving out = leaving(terrain, triangle, piece);
    if (out.time_s > piece.duration_s) {
        return piece;
    }
    constexpr int most_refinements = 8;
    for (int i = 0; i < most_refinements; ++i) {
        // The parabola of a step that ends nearly at the edge crosses it where the path does.
        const double until_s = out.time_s;
        if ((piece.position_m(until_s) - start_m).norm() < edge_tolerance_m) {
            break;  // at the edge already; the difference of two places so near says nothing of the way
        }
        piece = piece_of(start, sliding_step(start, normal, friction, until_s, tolerance_m), triangle);
        const Leaving again = leaving(terrain, triangle, piece);
        if (!std::isfinite(again.time_s)) {
            break;
        }
        const double moved_m = std::abs(again.time_s - out.time_s) * piece.velocity_at(until_s).norm();
        out = again;
        if (moved_m < edge_tolerance_m) {
            break;
        }
    }
    out.time_s = std::min(out.time_s, piece.duration_s);
    end_at_edge(piece, terrain, triangle, out);
    return piece;
}

}  // namespace rockfall::pir3d
