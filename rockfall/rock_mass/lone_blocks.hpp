#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "rockfall/solids/free_rotation.hpp"

namespace rockfall::rock_mass {

/// A lone block leaves its mass only if it is faster than this [m/s] [choice]; a slower one comes to rest
/// where it is.
inline constexpr double lone_speed_mps = 0.5;

/// A lone block stays in its mass while the ground under it holds more than this share of its motion, as in
/// the middle of an impact [-] [choice]: what the ground holds cannot go with it.
inline constexpr double lone_strain_share = 0.1;

/// A block as it leaves a rock mass to go on under another motion model.
struct HandedBlock {
    std::uint32_t number = 0;
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();
    solids::Rotation rotation{Eigen::Quaterniond::Identity(), Eigen::Vector3d::Zero()};
    bool on_ground = false;
    double motion_j = 0.0;   ///< translation and rotation, which go with it
    double gravity_j = 0.0;  ///< of its height above its start, which goes with it
    /// Lost at the crossing: held by its contact with the ground, and motion of mass that was added to it.
    double strain_j = 0.0;
};

/// A block as it comes back into its mass.
struct BlockBack {
    std::uint32_t number = 0;
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();
    solids::Rotation rotation{Eigen::Quaterniond::Identity(), Eigen::Vector3d::Zero()};
};

/// What a mass took back.
struct TakenBack {
    double motion_j = 0.0;  ///< translation and rotation, after the lift was paid for
    double lift_m = 0.0;    ///< how far it was lifted, as it lay in the ground of the mass
    double strain_j = 0.0;  ///< of overlaps with other blocks
};

}  // namespace rockfall::rock_mass
