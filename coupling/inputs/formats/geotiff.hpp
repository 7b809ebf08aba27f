#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/grid/raster.hpp"

namespace coupling::formats {

struct TiffBytes;

/// A grid and the coordinate system that its file names.
struct PlacedGrid {
    config::Raster<double> raster;  ///< NODATA cells are NaN
    std::string projection;         ///< well-known text, empty where the file names none
    /// What the user should know about how it was read: sentences without the name of the file.
    std::vector<std::string> remarks;
};

/// Whether bytes begin as a TIFF does, also a BigTIFF.
bool is_tiff(std::string_view bytes);

/// The most cells of a GeoTIFF that is read, as many as maps may have.
inline constexpr std::size_t most_tiff_cells = 400'000'000;

/// Reads a GeoTIFF of one band from its bytes: whole numbers of 8 to 64 bits, floats of 32 and 64; strips or
/// tiles; every compression that libtiff knows here; cells as areas or as points. `world_file` is the text of
/// the world file beside it, which counts where the file has no place of its own; empty: none.
///
/// Cells become NaN where the NODATA tag of GDAL says so, and where a float is NaN. Memory grows with the
/// cells that the file really holds, not with those it claims.
///
/// Throws InputError (data) naming what a grid of ours cannot have: several bands, complex or packed numbers,
/// cells in feet, a mask, a scale and offset, a rotation, no place on the map, an
/// unknown compression, a file cut off.
PlacedGrid read_geotiff(std::string_view bytes, const std::string& file, std::string_view world_file = {});

/// Place and coordinate system of a grid, without its cells.
struct GridHead {
    config::GridFrame frame;
    std::string projection;
};

/// The same without the cells, of which no byte is read. Throws as `read_geotiff` where tags alone show the
/// fault.
GridHead read_geotiff_head(TiffBytes& source, const std::string& file, std::string_view world_file = {});

}  // namespace coupling::formats
