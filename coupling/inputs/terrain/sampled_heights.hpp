#pragma once

#include "config/grid/raster.hpp"
#include "coupling/inputs/terrain/terrain_input.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling::plausible {

/// The heights of points, contours or meshes as a grid, for the rules on heights.
///
/// - Points on a lattice, such as the cells of a grid that was written as points or as a mesh, are that grid:
///   midway between them steps, stripes and single wrong cells would be averaged away.
/// - Else the terrain between the points, at their mean spacing rounded up, in cells about the middle of
/// their
///   extent, so that a turned or mirrored terrain has the same ones.
///
/// Absolute coordinates. Requires points, and a terrain of them.
config::Raster<double> sampled_heights(const HeightInput& heights, const rockfall::Terrain& terrain);

}  // namespace coupling::plausible
