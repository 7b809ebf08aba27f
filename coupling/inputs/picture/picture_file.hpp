#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "config/grid/raster.hpp"
#include "coupling/inputs/formats/read_file.hpp"

namespace coupling::picture {

/// A picture in red, green and blue, three bytes a pixel, row by row from the top. What is see-through in the
/// file lies on white.
struct Pixels {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint8_t> rgb;
};

/// A picture, where its pixels lie on the map, and what its file says of their coordinates.
struct PlacedPicture {
    Pixels pixels;
    config::GridFrame frame;  ///< a cell is a pixel
    std::string projection;   ///< well-known text; empty: the file names none
};

/// The most pixels of a picture that is read [choice]: 300 MB of memory.
inline constexpr std::uint64_t most_pixels = 100'000'000;

/// Reads a GeoTIFF (grey, palette, RGB, YCbCr; also with its world file), or a PNG or JPEG with its world
/// file: .pgw, .jgw, .pngw, .jpgw, .jpegw or .wld. A .prj beside it says what its own tags do not.
///
/// Throws InputError (data) naming what is wrong: no picture of these kinds, damaged or cut off, too many
/// pixels, no place on the map, rotated rows.
PlacedPicture read_picture(std::string_view bytes, const std::string& file,
                           const formats::BytesBeside& beside);

}  // namespace coupling::picture
