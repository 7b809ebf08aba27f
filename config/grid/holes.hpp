#pragma once

#include <cstddef>
#include <vector>

#include "config/grid/raster.hpp"

namespace config {

/// Cells without a value that cells with one lie all around.
struct Hole {
    std::size_t first_cell = 0;  ///< in row-major order from the north-west
    std::size_t cells = 0;
};

/// The holes of a grid, the first one in row-major order first. Cells without value (NaN) hang together over
/// edges and corners; those that hang together with the rim are no hole but outside.
std::vector<Hole> holes_of(const Raster<double>& raster);

}  // namespace config
