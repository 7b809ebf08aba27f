#pragma once

#include <cstddef>

#include "config/grid/raster.hpp"

namespace coupling {

/// Cells from which rocks may break off, by slope alone: steeper than 55 degrees * size^-0.075 of a cell in
/// metres, as Rockyfor3D proposes (Dorren 2016). A guess: cliffs are known better on the ground.
double source_slope_deg(double cell_size_m);

/// Cells that are steeper than a slope.
struct SteepCells {
    config::Raster<double> marks;  ///< 1: steeper, else 0
    std::size_t count = 0;
};

/// By central differences; cells on the border and beside missing heights are none.
SteepCells cells_steeper_than(double slope_deg, const config::Raster<double>& heights_m);

}  // namespace coupling
