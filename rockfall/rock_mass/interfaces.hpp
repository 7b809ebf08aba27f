#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "rockfall/rock_mass/convex_cell.hpp"

namespace rockfall::rock_mass {

/// The polygon that two cells share.
struct Interface {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    std::vector<Eigen::Vector3d> polygon_m;
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, from the first to the second cell
    double area_m2 = 0.0;
    int made_by = 0;
};

/// All polygons of at least a square centimetre that two cells share: faces in one plane (within a hundredth
/// of a millimetre) that look at each other and overlap. Sorted by cells.
std::vector<Interface> shared_faces(std::span<const ConvexCell> cells);

}  // namespace rockfall::rock_mass
