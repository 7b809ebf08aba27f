#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <vector>

#include "rockfall/solids/mass_properties.hpp"

namespace coupling::collapse {

/// Where a block is, and how far any point of it may go until blocks are looked at again.
struct BlockOnWay {
    const rockfall::solids::Solid* solid = nullptr;  ///< null: the block is not there any more
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
    Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
    double way_m = 0.0;
    bool is_single = false;  ///< one that is asked for
};

/// Blocks count as near whatever their ways at this share of the radii of the balls around both: places on
/// the ground are taken from chords [-] [choice].
inline constexpr double clearance_by_radius = 0.02;

/// No point of a block is ever faster, whatever turns into what, as long as it gains no energy.
double fastest_point_mps(const rockfall::solids::Solid& solid, double kinetic_j);
/// Bound of the speed of its points as it moves now.
double point_speed_mps(const rockfall::solids::Solid& solid, double speed_mps, double rotation_j);
/// The way in a time that begins with a speed, with what gravity adds.
double way_within_m(double speed_mps, double time_s);

/// Which single ones another block may touch before blocks are looked at again; 1: it may.
std::vector<std::uint8_t> singles_near_others(std::span<const BlockOnWay> blocks);

}  // namespace coupling::collapse
