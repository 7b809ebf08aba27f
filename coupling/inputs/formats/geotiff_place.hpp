#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "config/grid/raster.hpp"

struct tiff;

namespace coupling::formats {

/// Where the cells of a GeoTIFF lie: by its tie point and scale or its matrix, else by the six numbers of its
/// world file (empty: none), which name the centre of the north-western cell. The corner is rounded to a
/// millionth of a metre where only the last bits differ from that.
///
/// Throws InputError (data) for no place, rotated rows, several tie points, cells and corners of other sizes
/// than a grid may have, and world files that are none.
config::GridFrame frame_of_tiff(tiff* tiff, std::uint32_t columns, std::uint32_t rows, bool cells_are_points,
                                std::string_view world_file, const std::string& file);

/// The same by a world file alone.
config::GridFrame frame_of_world_file(std::string_view world_file, std::uint32_t columns, std::uint32_t rows,
                                      const std::string& file);

/// Holds the world file beside a GeoTIFF against the place of its cells. Throws InputError (data) where the
/// two lie more than half a cell apart or speak of cells of another size. A shift of up to half a cell, by
/// which some programs name the corner for the centre, is a sentence without the name of the file; "" where
/// the two agree or no six numbers stand there.
std::string judge_world_file(const config::GridFrame& frame, std::string_view world_file,
                             const std::string& file);

}  // namespace coupling::formats
