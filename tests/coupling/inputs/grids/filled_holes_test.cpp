#include "coupling/inputs/grids/filled_holes.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coupling::grids::filled_holes_test {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

config::Raster<double> plane(double width_m, double height_m) {
    config::GridFrame frame{.columns = 12,
                            .rows = 10,
                            .x_west_m = 1000.0,
                            .y_south_m = 2000.0,
                            .cell_width_m = width_m,
                            .cell_height_m = height_m};
    config::Raster<double> grid{frame};
    for (std::size_t i = 0; i < grid.values.size(); ++i) {
        const config::Cell cell = frame.cell_of(i);
        grid.values[i] = 1500.0 + 0.7 * frame.x_centre_m(cell.column) - 0.3 * frame.y_centre_m(cell.row);
    }
    return grid;
}

// The membrane over a plane rim is that plane, whatever the hole looks like and however long its cells are.
TEST(FillHoles, RestoresAPlane) {
    EXPECT_TRUE(rc::check([] {
        const config::Raster<double> whole = plane(2.0, *rc::gen::element(1.0, 2.0, 3.0));
        config::Raster<double> grid = whole;
        std::size_t missing = 0;
        for (int row = 1; row < 9; ++row) {
            for (int column = 1; column < 11; ++column) {
                if (*rc::gen::inRange(0, 3) == 0) {
                    grid.at({column, row}) = none;
                    ++missing;
                }
            }
        }
        const FilledHoles filled = fill_holes(grid, 1e6);
        RC_ASSERT(filled.cells.size() == missing);
        for (std::size_t i = 0; i < grid.values.size(); ++i) {
            RC_ASSERT(std::abs(grid.values[i] - whole.values[i]) < 1e-9);
        }
    }));
}

TEST(FillHoles, StaysWithinTheHeightsOfTheRim) {
    config::Raster<double> grid = plane(5.0, 5.0);
    for (std::size_t i = 0; i < grid.values.size(); ++i) {
        grid.values[i] = 400.0 + 50.0 * std::sin(static_cast<double>(7 * i));
    }
    for (int row = 3; row < 7; ++row) {
        for (int column = 4; column < 9; ++column) {
            grid.at({column, row}) = none;
        }
    }
    double low_m = 1e9;
    double high_m = -1e9;
    for (int row = 2; row < 8; ++row) {
        for (int column = 3; column < 10; ++column) {
            if (const double height_m = grid.at({column, row}); !std::isnan(height_m)) {
                low_m = std::min(low_m, height_m);
                high_m = std::max(high_m, height_m);
            }
        }
    }
    const FilledHoles filled = fill_holes(grid, 500.0);
    EXPECT_EQ(filled.holes, 1U);
    EXPECT_EQ(filled.cells.size(), 20U);
    for (const std::size_t cell : filled.cells) {
        EXPECT_GE(grid.values[cell], low_m);
        EXPECT_LE(grid.values[cell], high_m);
    }
}

TEST(FillHoles, LeavesLargeHolesAndTheRimAlone) {
    config::Raster<double> grid = plane(5.0, 5.0);
    grid.at({0, 4}) = none;  // on the border
    grid.at({3, 3}) = none;  // one cell: 25 m2
    grid.at({6, 6}) = none;  // two cells over a corner: 50 m2
    grid.at({7, 7}) = none;
    const FilledHoles filled = fill_holes(grid, 25.0);
    EXPECT_EQ(filled.holes, 1U);
    EXPECT_EQ(filled.cells, (std::vector<std::size_t>{grid.frame.index({3, 3})}));
    EXPECT_TRUE(std::isnan(grid.at({0, 4})));
    EXPECT_TRUE(std::isnan(grid.at({6, 6})));
    EXPECT_EQ(fill_holes(grid, 0.0).holes, 0U);
    EXPECT_EQ(fill_holes(grid, 50.0).cells.size(), 2U);
    EXPECT_TRUE(std::isnan(grid.at({0, 4})));
}

TEST(TakeNearest, GivesCodesOfTheNearestCell) {
    config::Raster<double> codes = plane(5.0, 5.0);
    std::fill(codes.values.begin(), codes.values.end(), none);
    codes.at({1, 5}) = 3.0;
    codes.at({6, 5}) = 7.0;
    const std::vector<std::size_t> cells{codes.frame.index({2, 5}), codes.frame.index({5, 5}),
                                         codes.frame.index({11, 0})};
    take_nearest(codes, cells, 4);
    EXPECT_EQ(codes.at({2, 5}), 3.0);
    EXPECT_EQ(codes.at({5, 5}), 7.0);
    EXPECT_TRUE(std::isnan(codes.at({11, 0})));  // too far from any
    EXPECT_TRUE(std::isnan(codes.at({4, 5})));   // nobody asked
}

}  // namespace
}  // namespace coupling::grids::filled_holes_test
