#pragma once

#include <vector>

#include "config/grid/raster.hpp"

namespace rockfall {

/// The ground that a height grid describes: of each square between four neighbouring cell centres all of it
/// where the four are known, the half with three known corners where one is missing (NaN), else nothing.
///
/// Its outline runs along sides and diagonals of such squares. All of these are edges of the Delaunay
/// triangulation as soon as `outline_cells` are among its vertices: the disc over a side holds no other
/// centre, and the triangle of a square with one missing corner has an empty circumcircle. So each triangle
/// lies wholly on the ground or wholly off it.

/// Does a triangle lie on the ground? Requires the three different cells at its corners, not in one line.
[[nodiscard]] bool lies_on_ground(const config::Raster<double>& heights, config::Cell a, config::Cell b,
                                  config::Cell c);

/// Known cells that fix the outline: the grid's corners and all with a missing cell among their eight
/// neighbours.
[[nodiscard]] std::vector<config::Cell> outline_cells(const config::Raster<double>& heights);

}  // namespace rockfall
