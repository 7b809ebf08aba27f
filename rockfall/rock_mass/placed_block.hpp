#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "rockfall/rock_mass/polygon.hpp"

namespace rockfall::rock_mass {

/// A convex block where it lies now, in the axes of space: what laws of contact look at.
struct PlacedBlock {
    std::span<const Eigen::Vector3d> vertices_m;
    std::span<const Plane3> faces;                ///< outward unit normals
    std::span<const std::uint16_t> first_corner;  ///< of each face; one more at the end
    std::span<const std::uint16_t> corners;       ///< vertices, counter-clockwise seen from outside
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
    double radius_m = 0.0;  ///< of the sphere about the centre that holds the block

    [[nodiscard]] std::span<const std::uint16_t> corners_of(std::size_t face) const {
        return corners.subspan(first_corner[face],
                               static_cast<std::size_t>(first_corner[face + 1] - first_corner[face]));
    }
};

}  // namespace rockfall::rock_mass
