#pragma once

#include <string>
#include <string_view>

#include "config/grid/raster.hpp"

namespace coupling::grids {

/// Whether a name is that of a grid of bare numbers, which a header (.hdr) beside it describes: `.flt`,
/// `.bil`, also with `.gz` behind.
bool is_raw_grid(const std::string& file);

/// Place of such a grid by the text of its header.
///
/// Two kinds are read: ESRI's floats (`ncols`, `nrows`, `xllcorner`, `cellsize`, `NODATA_value`,
/// `byteorder`), and one band of EHdr (`NROWS`, `NCOLS`, `NBITS`, `PIXELTYPE`, `BYTEORDER`, `ULXMAP`,
/// `ULYMAP`, `XDIM`, `YDIM`, `NODATA`, `SKIPBYTES`, `TOTALROWBYTES`), whose place is the centre of the
/// north-western cell. Numbers are floats of 32 bits or whole numbers of 8, 16 and 32.
///
/// Throws InputError for a header that is missing (file) or that says something else (data).
config::GridFrame read_raw_frame(std::string_view header, const std::string& file);

/// The grid from its bytes and its header; NODATA cells become NaN. Throws as above, and InputError (data)
/// where the file has another size than the header says.
config::Raster<double> read_raw_grid(std::string_view bytes, std::string_view header,
                                     const std::string& file);

}  // namespace coupling::grids
