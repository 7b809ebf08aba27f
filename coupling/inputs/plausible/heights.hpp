#pragma once

#include <string>

#include "config/grid/raster.hpp"
#include "coupling/inputs/reading.hpp"

namespace coupling::plausible {

/// Throws config::InputError (data) for heights below -500 or above 9000 m, which no mountain has, with the
/// likely cause: a NODATA value that the file does not declare, or another unit.
void check_height_range(double low_m, double high_m, const std::string& file);

/// That, cells of 0 that stand for NODATA (a warning), and slopes that no terrain has: throws where half of
/// the cells are steeper than 80 degrees, as heights in centimetres or cells in kilometres make them.
/// Requires at least one height that is known.
void check_grid_heights(const config::Raster<double>& grid, const std::string& file, Reading& reading);

/// Rocks that come to a hole are lost from the count behind it: warns of NODATA inside.
void doubt_holes(const config::Raster<double>& grid, const std::string& file, config::Effect effect,
                 Reading& reading);

}  // namespace coupling::plausible
