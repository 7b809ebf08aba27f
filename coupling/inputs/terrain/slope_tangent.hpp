#pragma once

#include <cstddef>
#include <optional>

#include "coupling/inputs/terrain/terrain_input.hpp"

namespace coupling {

/// Tangent of the slope of the ground at the centre of a cell [-], before any contact zone.
///
/// On grids that of Horn (1981) over 3 x 3 cells, as GIS programs compute it: the least-squares plane with
/// weights 1 at the corners and 2 at the sides. Where neighbours are missing the plane through the known
/// ones. On points and meshes that of the face. Nothing where there is no ground, or too little of it.
/// Source: Horn, B.K.P. (1981), Proc. IEEE 69(1):14-47.
std::optional<double> slope_tangent(const HeightInput& heights, const config::GridFrame& frame,
                                    const rockfall::Terrain& terrain, std::size_t cell);

/// Tangent of an angle in degrees, below 90; the same on every machine.
double tangent_of_deg(double angle_deg);

}  // namespace coupling
