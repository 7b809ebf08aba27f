#include "coupling/assessments/decades/report/forest_ground.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/forest/small_forest.hpp"

namespace coupling::decades::forest_ground_test {
namespace {

using forest::square_of_forest;

/// Patches on a frame of cells, where the picture shows a letter, on flat ground.
forest::PatchGrid forest_like(const std::vector<std::string>& rows) {
    const config::GridFrame frame{.columns = static_cast<int>(rows[0].size()),
                                  .rows = static_cast<int>(rows.size()),
                                  .cell_width_m = 10.0,
                                  .cell_height_m = 10.0};
    std::vector<forest::Patch> patches;
    for (int row = 0; row < frame.rows; ++row) {
        for (int column = 0; column < frame.columns; ++column) {
            if (rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] != '.') {
                patches.emplace_back();
                patches.back().cell = {column, row};
                patches.back().ground_m = 500.0;
            }
        }
    }
    return {frame, patches};
}

TEST(ForestGround, IsThePlaneThatPatchesLieOn) {
    // 30 degrees down to the south from 1000 m at the northern edge, also at the rim and on a single patch.
    const double steepness = std::tan(config::Angle::from_degrees(30.0).in_radians());
    for (const int side : {1, 2, 5}) {
        const ForestGround ground{square_of_forest(side)};
        for (double y_m = 0.5; y_m < 10.0 * side; y_m += 1.7) {
            EXPECT_NEAR(ground.height_m(0.3, y_m), 1000.0 - steepness * (10.0 * side - y_m), 1e-9) << y_m;
        }
    }
}

TEST(ForestGround, EndsACellBeyondThePatches) {
    const ForestGround ground{square_of_forest(3)};
    EXPECT_TRUE(std::isfinite(ground.height_m(-4.9, 15.0)));
    EXPECT_TRUE(std::isnan(ground.height_m(-5.1, 15.0)));
}

TEST(WindowOf, TakesAllOfASmallForest) {
    const StandWindow window = window_of(forest_like({"....", ".xx.", "..x."}));
    EXPECT_TRUE(window.whole);
    EXPECT_EQ(window.frame.columns, 2);
    EXPECT_EQ(window.frame.rows, 2);
    EXPECT_EQ(window.frame.x_west_m, 10.0);
    EXPECT_EQ(window.frame.y_south_m, 0.0);
}

TEST(WindowOf, TakesAHectareOfALargeForest) {
    const StandWindow window = window_of(square_of_forest(30));
    EXPECT_FALSE(window.whole);
    EXPECT_EQ(window.frame.x_east_m() - window.frame.x_west_m, 100.0);
    EXPECT_EQ(window.frame.x_west_m, 100.0) << "in the middle";
    EXPECT_EQ(window.frame.y_south_m, 100.0);
}

TEST(TransectOf, FallsWithTheSlope) {
    // The square faces south: down is -y.
    const forest::PatchGrid grid = square_of_forest(30);
    const Transect strip = transect_of(grid, window_of(grid));
    EXPECT_TRUE(strip.falls);
    EXPECT_NEAR(strip.along_x, 0.0, 1e-12);
    EXPECT_NEAR(strip.along_y, -1.0, 1e-12);
    EXPECT_EQ(strip.length_m, 100.0);
    const ForestGround ground{grid};
    EXPECT_GT(ground.height_m(strip.x_at(0.0), strip.y_at(0.0)),
              ground.height_m(strip.x_at(100.0), strip.y_at(100.0)) + 50.0);
    // East is on the left of one who looks south.
    EXPECT_NEAR(strip.offset_m(strip.x_m + 3.0, strip.y_m - 20.0), 3.0, 1e-9);
    EXPECT_NEAR(strip.distance_m(strip.x_m + 3.0, strip.y_m - 20.0), 20.0, 1e-9);
}

TEST(TransectOf, RunsEastOnFlatGroundAndEndsWhereTheForestDoes) {
    const forest::PatchGrid grid = forest_like({"xxx.x"});
    const Transect strip = transect_of(grid, window_of(grid));
    EXPECT_FALSE(strip.falls);
    EXPECT_EQ(strip.along_x, 1.0);
    EXPECT_GT(strip.length_m, 27.0);
    EXPECT_LE(strip.length_m, 30.0);
    EXPECT_GE(strip.x_m, 0.0);
}

}  // namespace
}  // namespace coupling::decades::forest_ground_test
