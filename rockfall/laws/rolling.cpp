#include "rockfall/laws/rolling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "config/units/constants.hpp"
#include "rockfall/laws/leaving.hpp"

namespace rockfall {
namespace {

using config::gravity_mps2;

constexpr double never_rests = std::numeric_limits<double>::infinity();
constexpr double standing_mps = 1e-2;
constexpr double largest_turn_rad = 0.03;
constexpr double longest_curved_piece_s = 0.25;

/// Gravity along the plane.
inline Eigen::Vector3d gravity_along(const Eigen::Vector3d& normal) {
    return -gravity_mps2 * (Eigen::Vector3d::UnitZ() - normal.z() * normal);
}

/// Acceleration of a sphere that rolls on a plane where gravity along the plane is known.
inline Eigen::Vector3d acceleration_of(const Eigen::Vector3d& gravity_along_mps2, double normal_z,
                                       const Eigen::Vector3d& direction, double friction) {
    return rolling_mass_factor * (gravity_along_mps2 - friction * gravity_mps2 * normal_z * direction);
}

/// First time at which |v + a t| rises to a speed.
double time_to_speed(const Eigen::Vector3d& velocity, const Eigen::Vector3d& acceleration, double speed) {
    const double a = acceleration.squaredNorm();
    const double b = 2.0 * velocity.dot(acceleration);
    const double c = velocity.squaredNorm() - speed * speed;
    if (c >= 0.0 || a == 0.0) {
        return c >= 0.0 ? 0.0 : never_rests;
    }
    const double root = std::sqrt(b * b - 4.0 * a * c);
    return b >= 0.0 ? -2.0 * c / (b + root) : (root - b) / (2.0 * a);
}

/// Longest time over which one acceleration describes the motion.
double longest_piece_s(const Eigen::Vector3d& velocity, double speed_mps, const Eigen::Vector3d& direction,
                       const Eigen::Vector3d& acceleration) {
    const double along = acceleration.dot(direction);
    const double across = (acceleration - along * direction).norm();
    const bool straight = across < 1e-9 * gravity_mps2;
    if (straight) {
        return along < 0.0 ? speed_mps / -along : never_rests;
    }
    const double longest_s = std::min(longest_curved_piece_s, largest_turn_rad * velocity.norm() / across);
    if (along >= 0.0) {
        return std::max(longest_s, shortest_rolling_piece_s);
    }
    // Friction brings a rock to rest but never drives it back.
    const double until_rest_s = speed_mps / -along;
    return std::min(std::max(std::min(longest_s, 0.5 * until_rest_s), shortest_rolling_piece_s),
                    until_rest_s);
}

}  // namespace

OwnMotion RollingPiece::own_at(double time_s) const {
    const double length_m = (position_m(duration_s) - start_m).norm();
    if (!has_own() || length_m == 0.0) {
        return own_end;
    }
    const double share = std::clamp((position_m(time_s) - start_m).norm() / length_m, 0.0, 1.0);
    return {own_start.squared_speed + share * (own_end.squared_speed - own_start.squared_speed),
            own_start.rotation_j + share * (own_end.rotation_j - own_start.rotation_j)};
}

double RollingPiece::time_along_s(double share) const {
    const Eigen::Vector3d way = position_m(duration_s) - start_m;
    const double length_m = way.norm();
    if (length_m == 0.0) {
        return share * duration_s;
    }
    const double speed = velocity_mps.dot(way) / length_m;
    const double acceleration = acceleration_mps2.dot(way) / length_m;
    const double root = std::sqrt(std::max(0.0, speed * speed + 2.0 * acceleration * share * length_m));
    const double twice_mean = speed + root;
    // From rest nothing of the way takes no time: an obstacle that touches the rock where it sets off.
    return twice_mean > 0.0 ? std::clamp(2.0 * share * length_m / twice_mean, 0.0, duration_s) : 0.0;
}

Eigen::Vector3d rolling_acceleration(const Eigen::Vector3d& normal, const Eigen::Vector3d& direction,
                                     double friction) {
    return acceleration_of(gravity_along(normal), normal.z(), direction, friction);
}

RollingPiece roll(const Terrain& terrain, std::uint32_t triangle, const Face& face,
                  const Eigen::Vector3d& start_m, const Eigen::Vector3d& velocity_mps, double friction,
                  double launch_speed_mps) {
    const double speed_mps = velocity_mps.norm();
    RollingPiece piece{start_m, velocity_mps, Eigen::Vector3d::Zero(), 0.0, RollingEnd::standstill, triangle};
    if (speed_mps < standing_mps && !(face.plane.gradient.norm() > friction)) {
        return piece;
    }
    const Eigen::Vector3d along_face_mps2 = gravity_along(face.normal);
    const Eigen::Vector3d direction = speed_mps < standing_mps ? Eigen::Vector3d{along_face_mps2.normalized()}
                                                               : Eigen::Vector3d{velocity_mps / speed_mps};
    piece.acceleration_mps2 = acceleration_of(along_face_mps2, face.normal.z(), direction, friction);
    piece.duration_s = longest_piece_s(velocity_mps, speed_mps, direction, piece.acceleration_mps2);
    piece.end = RollingEnd::piece;
    if (std::isfinite(piece.duration_s)) {
        const Eigen::Vector3d middle = velocity_mps + 0.5 * piece.duration_s * piece.acceleration_mps2;
        const double middle_mps = middle.norm();
        if (middle_mps > standing_mps) {
            piece.acceleration_mps2 =
                acceleration_of(along_face_mps2, face.normal.z(), middle / middle_mps, friction);
        }
    }
    const double launch_s = time_to_speed(velocity_mps, piece.acceleration_mps2, launch_speed_mps);
    if (launch_s < piece.duration_s) {
        piece.duration_s = launch_s;
        piece.end = RollingEnd::launch_speed;
    }
    end_near_edge(piece, terrain, triangle, face.plane, leaving_in_time(terrain, triangle, piece));
    return piece;
}

}  // namespace rockfall
