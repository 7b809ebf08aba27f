#pragma once

#include <cstdint>
#include <vector>

#include "rockfall/rock_mass/convex_cell.hpp"

namespace rockfall::rock_mass {

/// What makes the faces of Voronoi cells: no joint, but rock that breaks there.
inline constexpr int made_by_cell = -1;
/// What makes faces at the border of a body.
inline constexpr int made_by_border = -2;

/// Voronoi cells of points at random places in a box, as many as cubes of side `size_m` fill it, at least
/// two; computed by Voro++ (Rycroft 2009, Chaos 19:041111). Points keep a third of `size_m` apart as far as
/// that goes, or many cells would be slivers.
std::vector<ConvexCell> voronoi_cells(const Eigen::Vector3d& low_m, const Eigen::Vector3d& high_m,
                                      double size_m, std::uint64_t seed);

}  // namespace rockfall::rock_mass
