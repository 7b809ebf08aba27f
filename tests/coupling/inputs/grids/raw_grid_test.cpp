#include "coupling/inputs/grids/raw_grid.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/coupling/inputs/formats/given_files.hpp"

namespace coupling::grids::raw_grid_test {
namespace {

/// Numbers byte by byte, the lowest first or last.
template <class Number>
std::string bytes_of(const std::vector<Number>& numbers, bool highest_first = false) {
    std::string bytes;
    for (const Number number : numbers) {
        std::uint64_t bits = 0;
        if constexpr (std::is_same_v<Number, float>) {
            bits = std::bit_cast<std::uint32_t>(number);
        } else {
            bits = static_cast<std::uint64_t>(number);
        }
        for (std::size_t i = 0; i < sizeof number; ++i) {
            const std::size_t shift = 8 * (highest_first ? sizeof number - 1 - i : i);
            bytes += static_cast<char>(bits >> shift & 0xFFU);
        }
    }
    return bytes;
}

constexpr const char* esri =
    "ncols 3\r\nnrows 2\r\nxllcorner 600000\r\nyllcorner 200000.5\r\ncellsize 0.5\r\nNODATA_value "
    "-9999\r\nbyteorder LSBFIRST\r\n";
const std::vector<float> heights{1.5F, 2.5F, -9999.0F, 4.0F, 5.0F, 6.25F};

TEST(RawGrid, ReadsFloatsOfEsri) {
    const config::Raster<double> grid = read_raw_grid(bytes_of(heights), esri, "dem.flt");
    EXPECT_EQ(grid.frame, (config::GridFrame{.columns = 3,
                                             .rows = 2,
                                             .x_west_m = 600'000.0,
                                             .y_south_m = 200'000.5,
                                             .cell_width_m = 0.5,
                                             .cell_height_m = 0.5}));
    EXPECT_EQ(grid.at({0, 0}), 1.5);
    EXPECT_TRUE(std::isnan(grid.at({2, 0})));
    EXPECT_EQ(grid.at({2, 1}), 6.25);
    std::string turned = esri;
    turned.replace(turned.find("LSB"), 3, "MSB");
    EXPECT_EQ(read_raw_grid(bytes_of(heights, true), turned, "dem.flt").at({2, 1}), 6.25);
}

TEST(RawGrid, ReadsWholeNumbersOfEhdr) {
    const std::string header =
        "BYTEORDER      I\nLAYOUT         BIL\nNROWS          2\nNCOLS          2\nNBANDS         1\nNBITS   "
        "  "
        "     16\nBANDROWBYTES         4\nTOTALROWBYTES        4\nPIXELTYPE      SIGNEDINT\nULXMAP         "
        "1002.5\nULYMAP         2017.5\nXDIM           5\nYDIM           5\nNODATA -1\n";
    const config::Raster<double> grid =
        read_raw_grid(bytes_of(std::vector<std::int16_t>{-1, -300, 70, 8000}), header, "dem.bil");
    EXPECT_EQ(grid.frame.x_west_m, 1000.0);
    EXPECT_EQ(grid.frame.y_south_m, 2010.0);
    EXPECT_TRUE(std::isnan(grid.at({0, 0})));
    EXPECT_EQ(grid.at({1, 0}), -300.0);
    EXPECT_EQ(grid.at({1, 1}), 8000.0);
}

TEST(RawGrid, IsKnownByItsEnding) {
    EXPECT_TRUE(is_raw_grid("DEM.FLT"));
    EXPECT_TRUE(is_raw_grid("dem.bil.gz"));
    EXPECT_FALSE(is_raw_grid("dem.tif"));
}

TEST(RawGrid, RefusesHeadersThatSayAnotherFile) {
    const auto refusal = [](const std::string& bytes, const std::string& header) {
        return refusal_of([&] { read_raw_grid(bytes, header, "dem.flt"); });
    };
    EXPECT_EQ(refusal(bytes_of(heights), ""),
              "dem.flt: found no header (.hdr) beside it, expected the header, which says where the cells "
              "lie; copy both "
              "files");
    EXPECT_NE(
        refusal(bytes_of(heights) + "x", esri).find("found 25 bytes, expected 24 bytes for 3 x 2 cells"),
        std::string::npos);
    EXPECT_NE(refusal("", "ENVI\nsamples = 3").find("a header (.hdr) of ENVI"), std::string::npos);
    std::string header = esri;
    header.replace(header.find("ncols 3"), 7, "ncols x");
    EXPECT_NE(refusal("", header).find("a header (.hdr) with ncols 'x'"), std::string::npos);
    header = esri;
    header.replace(header.find("cellsize 0.5"), 12, "cellsize 0.0");
    EXPECT_NE(refusal("", header).find("cells of 0 x 0"), std::string::npos);
    header = esri;
    header.replace(header.find("ncols 3"), 7, "ncols 400000000");
    EXPECT_NE(refusal("", header).find("400 million cells"), std::string::npos);
    header = std::string{esri} + "nbands 3\n";
    EXPECT_NE(refusal("", header).find("3 bands"), std::string::npos);
    header = esri;
    header.replace(header.find("xllcorner 600000"), 16, "");
    EXPECT_NE(refusal("", header).find("without xllcorner"), std::string::npos);
}

}  // namespace
}  // namespace coupling::grids::raw_grid_test
