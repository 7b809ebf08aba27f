#include "rockfall/obstacles/log_impact.hpp"

#include <algorithm>
#include <cmath>

#include "config/units/constants.hpp"

namespace rockfall {
namespace {

LogImpact pass(LogOutcome outcome, double energy_j, double loss_j, const Eigen::Vector3d& velocity_mps) {
    const double speed_factor = std::sqrt(std::max(0.0, energy_j - loss_j) / energy_j);
    return {outcome, loss_j, speed_factor * velocity_mps, speed_factor};
}

/// Energy that lifts the centre of a rock on its circle around the axis to the highest point: none once it
/// moves away from the axis, seen from above along the log.
double lift_j(const Rock& rock, const Eigen::Vector3d& across_mps, const LogHit& hit, const LogPiece& piece,
              const Eigen::Vector3d& axis) {
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ() - axis.z() * axis;
    const double squared_up = up.squaredNorm();
    const double ahead =
        across_mps.dot(hit.towards_rock) * squared_up - across_mps.dot(up) * up.dot(hit.towards_rock);
    if (ahead > 0.0) {
        return 0.0;
    }
    const double below_top = std::sqrt(squared_up) - up.dot(hit.towards_rock);
    return rock.mass_kg * config::gravity_mps2 * (rock.radius_m + piece.radius_m) * std::max(0.0, below_top);
}

/// The direction in which a rock slides along a log: its axis; around its end, level with the ground.
Eigen::Vector3d sliding_direction(const LogHit& hit, const LogPiece& piece) {
    const Eigen::Vector3d axis = piece.along.normalized();
    const Eigen::Vector3d around = piece.normal.cross(hit.towards_rock);
    const bool at_end = std::abs(hit.towards_rock.dot(axis)) > 1e-6;
    return at_end && around.norm() > 1e-6 ? Eigen::Vector3d{around.normalized()} : axis;
}

}  // namespace

LogImpact meet_log(double energy_j, const Eigen::Vector3d& velocity_mps, const Rock& rock, const LogHit& hit,
                   const LogPiece& piece, const LogImpactLaw& law) {
    const Eigen::Vector3d axis = sliding_direction(hit, piece);
    const double strength_j = law.energy_factor * piece.largest_energy_j;
    const double along_mps = velocity_mps.dot(axis);
    const double into_mps = velocity_mps.dot(hit.towards_rock);
    const double squared_speed = velocity_mps.squaredNorm();
    const Eigen::Vector3d across_mps = velocity_mps - along_mps * axis;
    const double squared_across = across_mps.squaredNorm();
    const double across_j = energy_j * squared_across / squared_speed;

    const double reach_m = rock.radius_m + piece.radius_m;
    const bool is_low = reach_m * hit.towards_rock.dot(piece.normal) > piece.radius_m;
    const double pressing_j =
        is_low ? std::min(across_j, energy_j * into_mps * into_mps / squared_speed) : across_j;
    if (pressing_j > strength_j) {
        return pass(LogOutcome::broke, energy_j, strength_j, velocity_mps);
    }
    if (is_low) {
        const double taken_j = std::min(law.climb_share * strength_j, pressing_j);
        if (across_j > lift_j(rock, across_mps, hit, piece, axis) + taken_j) {
            return pass(LogOutcome::climbed, energy_j, taken_j, velocity_mps);
        }
    }
    const double kept_mps = std::max(0.0, std::abs(along_mps) - law.friction * std::sqrt(squared_across));
    const double kept_share = kept_mps * kept_mps / squared_speed;
    if (kept_share < law.stop_share) {
        return rest_at(energy_j);
    }
    return {LogOutcome::turned, energy_j * (1.0 - kept_share),
            (along_mps < 0.0 ? -kept_mps : kept_mps) * axis, std::sqrt(kept_share)};
}

}  // namespace rockfall
