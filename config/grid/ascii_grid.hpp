#pragma once

#include <istream>
#include <ostream>
#include <string>
#include <string_view>

#include "config/grid/raster.hpp"

namespace config {

/// Reads an ESRI ASCII grid from its text; NODATA cells become NaN.
///
/// Takes xllcorner/yllcorner or xllcenter/yllcenter, keys in any case and order, cellsize or dx and dy, LF or
/// CRLF, tabs, rows broken over lines, a missing NODATA line, a leading plus. Throws InputError (data) with
/// line and column for a missing or doubled key, `nan`, `1,5`, too few or too many values, sizes below 1.
Raster<double> read_ascii_grid(std::string_view text, const std::string& file);

/// Writes a grid; NaN becomes -9999. Numbers are the shortest text that reads back the same.
void write_ascii_grid(std::ostream& out, const Raster<double>& raster);
/// Shortest text of the value as a float: for derived maps, about 7 digits.
void write_ascii_grid(std::ostream& out, const Raster<float>& raster);

}  // namespace config
