#pragma once

#include <array>

#include "config/grid/raster.hpp"

namespace rockfall {

/// The cell whose centre lies furthest, measured vertically, from a plane.
struct VerticalError {
    double error_m = 0.0;  ///< [0, ...); 0 where no cell centre but the corners lies in the triangle
    config::Cell cell;
};

/// Largest vertical error of the triangle between three cell centres, over the known cells in it and on its
/// edges. Of equal errors the north-western cell counts. Requires three known cells, not in one line.
[[nodiscard]] VerticalError largest_vertical_error(const config::Raster<double>& heights,
                                                   const std::array<config::Cell, 3>& corners);

}  // namespace rockfall
