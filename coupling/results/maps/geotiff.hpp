#pragma once

#include <filesystem>
#include <string>

#include "config/grid/raster.hpp"

namespace coupling {

/// Writes a grid as GeoTIFF: 32-bit floats, one strip, uncompressed, -9999 where there is no value.
///
/// `projection`: text of a .prj. One that ends with an EPSG authority goes in as its number; any other as
/// text, as ESRI's programs write it and GDAL reads it; empty: none. Requires square or rectangular cells, at
/// most 2^29 of them. Throws config::InputError (file).
void write_geotiff(const std::filesystem::path& file, const config::Raster<double>& raster,
                   const std::string& projection);

}  // namespace coupling
