#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "rockfall/laws/rolling.hpp"
#include "rockfall/motion/pir3d/runge_kutta_nystrom.hpp"
#include "rockfall/terrain/face.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace rockfall::pir3d {

/// A slower rock stands: the direction of friction has no meaning at rest.
inline constexpr double standing_mps = 1e-3;

/// A step of sliding on one triangle, as a piece that observers and obstacles understand.
///
/// Its place is a parabola from the exact start, with the exact velocity there, to the exact end; the
/// velocity goes evenly from that of the start to that of the end.
struct SlidingPiece : RollingPiece {
    Eigen::Vector3d velocity_rate_mps2;
    [[nodiscard]] Eigen::Vector3d velocity_at(double time_s) const {
        return velocity_mps + time_s * velocity_rate_mps2;
    }
};

/// Acceleration of a point that slides on a face: dV/dt = g_t - k g n_z V/|V| (Cottaz et al. 2010, Eqs. 4-5).
/// `direction` is the unit vector of the motion.
Eigen::Vector3d sliding_acceleration(const Eigen::Vector3d& normal, const Eigen::Vector3d& direction,
                                     double friction);

/// An accepted step from a point at rest, which starts down the fall line, or moving: no longer than
/// `longest_s`, its error below the tolerance.
struct SlidingStep {
    PointState end;
    double duration_s;
};
SlidingStep sliding_step(const PointState& start, const Eigen::Vector3d& normal, double friction,
                         double longest_s, double tolerance_m);

/// The next piece of sliding from a point on a triangle: ends at the edge of the triangle, at standstill on
/// ground too flat to start again, or after a step.
///
/// A step turns the motion by 0.05 rad at most, so that its parabola stays within a millimetre of the path,
/// and takes 0.25 s at most. The edge is found by steps to where the parabola of the step before crosses it.
/// Requires a velocity in the plane of the triangle.
SlidingPiece slide(const Terrain& terrain, std::uint32_t triangle, const Face& face,
                   const Eigen::Vector3d& start_m, const Eigen::Vector3d& velocity_mps, double friction,
                   double tolerance_m);

}  // namespace rockfall::pir3d
