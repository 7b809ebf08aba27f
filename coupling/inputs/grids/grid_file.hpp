#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "config/errors/input_error.hpp"
#include "coupling/inputs/formats/read_file.hpp"

namespace coupling::grids {

/// What a grid may be, for messages.
inline constexpr const char* grid_expected =
    "a grid: GeoTIFF, ESRI ASCII, .flt or .bil with .hdr, XYZ, or a folder, list or VRT of such tiles";

/// Reads one grid from the bytes of its file: what formats::read_grid_file reads, bare numbers with a header
/// beside them (`raw_grid`), and points that are the centres of the cells of a grid (`xyz_grid`).
formats::PlacedGrid read_grid_file(std::string_view bytes, const std::string& file,
                                   const formats::BytesBeside& beside);

/// Place and coordinate system of such a grid. Of a GeoTIFF its tags are read, of a text its beginning; a
/// packed file and points are read whole. Throws as `open_file` and `read_grid_file`.
formats::GridHead read_grid_head(const std::filesystem::path& path, const config::Place& asked_at,
                                 const std::string& file, const formats::BytesBeside& beside);

}  // namespace coupling::grids
