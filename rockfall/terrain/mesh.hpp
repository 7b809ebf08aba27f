#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "config/grid/raster.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace rockfall {

/// Delaunay triangulation of a height grid (NaN = hole), cell centres as vertices.
///
/// vertical_tolerance_m = 0 keeps every point; above 0 points are inserted greedily, the largest vertical
/// error first, until no cell centre lies further than the tolerance from the triangulation. Triangles that
/// cover NODATA (a corner cell missing within the triangle) are left out: holes stay holes.
Terrain triangulate(const config::Raster<double>& heights, double vertical_tolerance_m);

/// Delaunay triangulation of scattered points (absolute coordinates). Of points with the same plan position
/// the first counts. Triangles with an edge longer than `longest_edge_m` are left out (0 keeps all): the hull
/// of scattered points has slivers that are no terrain.
Terrain triangulate(std::span<const Eigen::Vector3d> points, double longest_edge_m);

}  // namespace rockfall
