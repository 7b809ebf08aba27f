#pragma once

#include <Eigen/Core>
#include <optional>

#include "rockfall/rock_mass/placed_block.hpp"

namespace rockfall::rock_mass {

/// A direction, from the first to the second of two blocks, along which they are apart.
struct SeparatingAxis {
    Eigen::Vector3d axis;  ///< unit
    double gap_m;          ///< along it
};

/// How far two blocks are apart along a unit vector from the first to the second; below 0 if they are not.
double apart_along_m(const Eigen::Vector3d& axis, const PlacedBlock& first, const PlacedBlock& second);

/// Looks for a direction that keeps two blocks apart, whatever their faces are, from a unit vector on; each
/// trial is mirrored at what it left between the two (Chung & Wang 1996, VRST, 125). What is found is exact,
/// but narrow gaps may be missed.
std::optional<SeparatingAxis> find_separating_axis(const Eigen::Vector3d& from, const PlacedBlock& first,
                                                   const PlacedBlock& second);

}  // namespace rockfall::rock_mass
