#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/results/figures/colours.hpp"

namespace coupling::report {

/// A picture of up to 256 colours, row by row from the top; index 0 is see-through.
struct IndexedPicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;
    std::vector<Colour> palette;
};

/// A picture in shades of grey, row by row from the top.
struct GreyPicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;
};

/// The bytes of a PNG file (PNG Specification, Third Edition), 8 bits a pixel.
std::string png(const IndexedPicture& picture);
std::string png(const GreyPicture& picture);

/// "data:image/png;base64,...".
std::string data_address(std::string_view png_bytes);

}  // namespace coupling::report
