#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/grid/raster.hpp"

namespace coupling::grids {

/// Some cells of a grid, from one in the north-west on.
struct CellWindow {
    config::Cell first;
    int columns = 0;
    int rows = 0;
    friend bool operator==(const CellWindow&, const CellWindow&) = default;
};

/// A file of which a virtual raster takes cells.
struct VrtSource {
    std::string file;          ///< from the folder of the virtual raster, unless it is absolute
    std::size_t line = 0;      ///< in the virtual raster
    CellWindow from;           ///< in the file
    config::Cell to;           ///< where the first of these cells stands in the virtual raster
    std::vector<double> none;  ///< values that stand for NODATA beside that of the file
};

/// A mosaic that GDAL describes in a file of XML (VRT).
struct VirtualRaster {
    config::GridFrame frame;
    std::string system;  ///< well-known text, "" without one
    std::vector<VrtSource> sources;
};

/// Whether bytes are such a file.
bool is_virtual_raster(std::string_view bytes);

/// Reads a virtual raster of one band whose sources are files with cells of the same size, as
/// `gdalbuildvrt` writes it. Throws InputError (data) for what would change cells: other sizes of cells,
/// rotations, factors, masks, several bands, computed or warped bands.
VirtualRaster read_virtual_raster(std::string_view bytes, const std::string& file);

}  // namespace coupling::grids
