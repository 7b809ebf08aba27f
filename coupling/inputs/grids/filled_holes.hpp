#pragma once

#include <cstddef>
#include <vector>

#include "config/grid/raster.hpp"

namespace coupling::grids {

/// What became of the holes of a grid.
struct FilledHoles {
    std::size_t holes = 0;           ///< that were filled
    std::vector<std::size_t> cells;  ///< of them, in row-major order
};

/// Fills holes of at most an area with the smoothest surface that their rim allows: each cell becomes the
/// mean of its four neighbours, weighted by the inverse square of their distance (Laplace's equation). A
/// plane is restored as it was, and no filled cell lies above or below its rim. Holes are those of
/// config/grid/holes: known cells enclose them. Larger ones, and what hangs together with the border of the
/// grid, stay.
FilledHoles fill_holes(config::Raster<double>& grid, double most_m2);

/// Gives cells without a value that of the nearest cell that has one, in the order of distance, then from
/// north-west to south-east: for codes of cells that were filled. Cells farther than `most_cells` stay.
void take_nearest(config::Raster<double>& codes, const std::vector<std::size_t>& cells, int most_cells);

}  // namespace coupling::grids
