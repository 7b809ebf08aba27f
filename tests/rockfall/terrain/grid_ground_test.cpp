#include "rockfall/terrain/grid_ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/rockfall/terrain/sample_slopes.hpp"

namespace rockfall::grid_ground_test {
namespace {

using config::Cell;

config::Raster<double> flat_grid(int columns, int rows, const std::vector<Cell>& holes) {
    config::Raster<double> heights{frame_of(columns, rows), 100.0};
    for (const Cell hole : holes) {
        heights.at(hole) = missing;
    }
    return heights;
}

TEST(LiesOnGround, BothHalvesOfAKnownSquare) {
    const config::Raster<double> heights = flat_grid(2, 2, {});
    EXPECT_TRUE(lies_on_ground(heights, {0, 0}, {0, 1}, {1, 0}));
    EXPECT_TRUE(lies_on_ground(heights, {1, 1}, {0, 1}, {1, 0}));
}

TEST(LiesOnGround, TheHalfWithThreeKnownCornersOnly) {
    const config::Raster<double> heights = flat_grid(3, 3, {{2, 2}});
    EXPECT_TRUE(lies_on_ground(heights, {1, 1}, {2, 1}, {1, 2}));
    // Across the corner that is missing, between cells that are known.
    EXPECT_FALSE(lies_on_ground(flat_grid(3, 3, {{1, 1}}), {1, 0}, {2, 1}, {0, 1}));
}

TEST(LiesOnGround, NothingBetweenTwoDiagonalHoles) {
    const config::Raster<double> heights = flat_grid(4, 2, {{1, 0}, {2, 1}});
    EXPECT_FALSE(lies_on_ground(heights, {0, 1}, {1, 1}, {3, 0}));
}

TEST(OutlineCells, AreTheCornersOfAGridWithoutHoles) {
    const std::vector<Cell> cells = outline_cells(flat_grid(7, 5, {}));
    EXPECT_EQ(cells, (std::vector<Cell>{{0, 0}, {6, 0}, {0, 4}, {6, 4}}));
}

TEST(OutlineCells, SurroundAHole) {
    const std::vector<Cell> cells = outline_cells(flat_grid(7, 5, {{3, 2}}));
    EXPECT_EQ(cells.size(), 4U + 8U);
    EXPECT_EQ(std::count(cells.begin(), cells.end(), Cell{3, 2}), 0);
    EXPECT_EQ(std::count(cells.begin(), cells.end(), Cell{2, 1}), 1);
}

}  // namespace
}  // namespace rockfall::grid_ground_test
