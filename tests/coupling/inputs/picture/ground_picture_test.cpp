#include "coupling/inputs/picture/ground_picture.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

namespace coupling::picture::ground_picture_test {
namespace {

/// A picture whose red grows eastward and whose green grows southward, a step a pixel.
PlacedPicture ramp(std::uint32_t width, std::uint32_t height, double pixel_m, double west_m, double south_m) {
    PlacedPicture placed;
    placed.pixels = {width, height, {}};
    for (std::uint32_t row = 0; row < height; ++row) {
        for (std::uint32_t column = 0; column < width; ++column) {
            placed.pixels.rgb.insert(placed.pixels.rgb.end(),
                                     {static_cast<std::uint8_t>(column), static_cast<std::uint8_t>(row), 7});
        }
    }
    placed.frame = {.columns = static_cast<int>(width),
                    .rows = static_cast<int>(height),
                    .x_west_m = west_m,
                    .y_south_m = south_m,
                    .cell_width_m = pixel_m,
                    .cell_height_m = pixel_m};
    return placed;
}

config::GridFrame map_of(double west_m, double south_m, int columns, int rows, double cell_m) {
    return {.columns = columns,
            .rows = rows,
            .x_west_m = west_m,
            .y_south_m = south_m,
            .cell_width_m = cell_m,
            .cell_height_m = cell_m};
}

TEST(CutOut, ShowsEachPlaceWhereItIs) {
    EXPECT_TRUE(rc::check([] {
        const double pixel_m = 0.5 * *rc::gen::inRange(1, 9);
        const PlacedPicture placed = ramp(static_cast<std::uint32_t>(*rc::gen::inRange(20, 250)),
                                          static_cast<std::uint32_t>(*rc::gen::inRange(20, 250)), pixel_m,
                                          *rc::gen::inRange(-50, 50), *rc::gen::inRange(-50, 50));
        const config::GridFrame map =
            map_of(*rc::gen::inRange(-60, 60), *rc::gen::inRange(-60, 60), *rc::gen::inRange(3, 60),
                   *rc::gen::inRange(3, 60), 0.7 * *rc::gen::inRange(1, 10));
        RC_PRE(covered_share(placed.frame, map) > 0.01);
        const auto most = static_cast<std::uint32_t>(*rc::gen::inRange(5, 300));
        const GroundPicture cut = cut_out(placed, map, most);
        RC_ASSERT(cut.pixels.width <= most && cut.pixels.height <= most);
        RC_ASSERT(cut.pixels.rgb.size() == 3U * cut.pixels.width * cut.pixels.height);
        // All of the map that the picture covers, and no more than a pixel beyond.
        const double slack_m = 1.001 * pixel_m;
        RC_ASSERT(cut.frame.x_west_m <= std::max(map.x_west_m, placed.frame.x_west_m) + 1e-6 * pixel_m);
        RC_ASSERT(cut.frame.x_west_m >= std::max(map.x_west_m, placed.frame.x_west_m) - slack_m);
        RC_ASSERT(cut.frame.x_east_m() <= std::min(map.x_east_m(), placed.frame.x_east_m()) + slack_m);
        RC_ASSERT(cut.frame.y_north_m() <= std::min(map.y_north_m(), placed.frame.y_north_m()) + slack_m);
        for (int row = 0; row < cut.frame.rows; ++row) {
            for (int column = 0; column < cut.frame.columns; ++column) {
                const std::uint8_t* pixel =
                    cut.pixels.rgb.data() +
                    3 * (static_cast<std::size_t>(row) * cut.pixels.width + static_cast<std::size_t>(column));
                // The colour of the pixel is the number of the pixels of the file that lie there.
                const double red = (cut.frame.x_centre_m(column) - placed.frame.x_west_m) / pixel_m - 0.5;
                const double green = (placed.frame.y_north_m() - cut.frame.y_centre_m(row)) / pixel_m - 0.5;
                RC_ASSERT(std::abs(pixel[0] - red) <= 1.5);
                RC_ASSERT(std::abs(pixel[1] - green) <= 1.5);
                RC_ASSERT(pixel[2] == 7);
            }
        }
    }));
}

TEST(CutOut, IsTheMeanOfThePixelsThatItStandsFor) {
    PlacedPicture placed = ramp(4, 4, 1.0, 0.0, 0.0);
    const GroundPicture half = cut_out(placed, map_of(0.0, 0.0, 4, 4, 1.0), 2);
    EXPECT_EQ(half.pixels.width, 2U);
    EXPECT_EQ(half.pixels.rgb, (std::vector<std::uint8_t>{1, 1, 7, 3, 1, 7, 1, 3, 7, 3, 3, 7}));
    EXPECT_DOUBLE_EQ(half.frame.cell_width_m, 2.0);
}

TEST(CoveredShare, IsThatOfTheMap) {
    const config::GridFrame map = map_of(0.0, 0.0, 10, 10, 10.0);
    EXPECT_DOUBLE_EQ(covered_share(map, map), 1.0);
    EXPECT_DOUBLE_EQ(covered_share(map_of(50.0, -20.0, 100, 100, 10.0), map), 0.5);
    EXPECT_DOUBLE_EQ(covered_share(map_of(100.0, 0.0, 1, 1, 10.0), map), 0.0);
    EXPECT_DOUBLE_EQ(covered_share(map_of(-500.0, 300.0, 1, 1, 10.0), map), 0.0);
}

}  // namespace
}  // namespace coupling::picture::ground_picture_test
