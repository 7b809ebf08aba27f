#include "coupling/inputs/grids/xyz_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coupling::grids::xyz_grid_test {
namespace {

/// Centres of 4 x 3 cells of 2 x 5 m, from the north-west.
std::vector<Eigen::Vector3d> points() {
    std::vector<Eigen::Vector3d> all;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            all.emplace_back(600'001.0 + 2.0 * column, 200'012.5 - 5.0 * row, 100.0 * row + column);
        }
    }
    return all;
}

TEST(GridOfPoints, TakesThemAsCentresInAnyOrder) {
    const auto grid = grid_of_points(points());
    ASSERT_TRUE(grid);
    EXPECT_EQ(grid->frame, (config::GridFrame{.columns = 4,
                                              .rows = 3,
                                              .x_west_m = 600'000.0,
                                              .y_south_m = 200'000.0,
                                              .cell_width_m = 2.0,
                                              .cell_height_m = 5.0}));
    EXPECT_EQ(grid->at({3, 2}), 203.0);
    std::vector<Eigen::Vector3d> turned = points();
    std::reverse(turned.begin(), turned.end());
    turned.push_back(turned.front());  // the same point twice
    const auto same = grid_of_points(turned);
    ASSERT_TRUE(same);
    EXPECT_EQ(same->frame, grid->frame);
    EXPECT_EQ(same->values, grid->values);
}

TEST(GridOfPoints, HasSquareCellsWhereDigitsAloneMakeThemDiffer) {
    // As gdal_translate prints cells of 4.9976889066 m.
    const auto grid = grid_of_points({{177200.832843453303, 378099.475494037324, 1.0},
                                      {177205.830532359891, 378099.475494037324, 2.0},
                                      {177200.832843453303, 378094.477805130736, 3.0},
                                      {177205.830532359891, 378094.477805130742, 4.0}});
    ASSERT_TRUE(grid);
    EXPECT_EQ(grid->frame.cell_width_m, grid->frame.cell_height_m);
    EXPECT_NEAR(grid->frame.cell_width_m, 4.9976889066, 1e-9);
}

TEST(GridOfPoints, LeavesCellsWithoutAPointUnknown) {
    std::vector<Eigen::Vector3d> some = points();
    some.erase(some.begin() + 5);
    const auto grid = grid_of_points(some);
    ASSERT_TRUE(grid);
    EXPECT_TRUE(std::isnan(grid->at({1, 1})));
}

TEST(GridOfPoints, IsNothingForOtherPoints) {
    EXPECT_FALSE(grid_of_points({}));
    std::vector<Eigen::Vector3d> off = points();
    off[6].x() += 0.3;
    EXPECT_FALSE(grid_of_points(off));
    std::vector<Eigen::Vector3d> two_heights = points();
    two_heights.push_back(two_heights.front() + Eigen::Vector3d{0.0, 0.0, 1.0});
    EXPECT_FALSE(grid_of_points(two_heights));
    EXPECT_FALSE(grid_of_points({{0, 0, 1}, {0, 1, 1}, {0, 2, 1}}));       // one column
    EXPECT_FALSE(grid_of_points({{0, 0, 1}, {1000, 1, 1}, {0, 999, 1}}));  // scattered
}

}  // namespace
}  // namespace coupling::grids::xyz_grid_test
