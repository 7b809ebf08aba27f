#include "config/grid/holes.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

namespace config::holes_test {
namespace {

/// 'x' a height, '.' none.
Raster<double> grid_of(const std::vector<std::string>& rows) {
    GridFrame frame;
    frame.columns = static_cast<int>(rows.front().size());
    frame.rows = static_cast<int>(rows.size());
    frame.cell_width_m = frame.cell_height_m = 1.0;
    Raster<double> raster{frame};
    std::size_t index = 0;
    for (const std::string& row : rows) {
        for (const char sign : row) {
            raster.values[index++] = sign == 'x' ? 1.0 : std::numeric_limits<double>::quiet_NaN();
        }
    }
    return raster;
}

TEST(HolesOf, AGridWithoutThemIsEmpty) {
    EXPECT_TRUE(holes_of(grid_of({"xxx", "xxx", "xxx"})).empty());
    EXPECT_TRUE(holes_of(grid_of({"..x", "x.x", "xxx"})).empty());
    EXPECT_TRUE(holes_of(grid_of({"...", "...", "..."})).empty());
}

TEST(HolesOf, AGridAreCountedWithTheirCells) {
    const std::vector<Hole> holes = holes_of(grid_of({"xxxxxxx.", "x.xx..x.", "x.xxx.xx", "xxxxxxxx"}));
    ASSERT_EQ(holes.size(), 2U);
    EXPECT_EQ(holes[0].first_cell, 9U);
    EXPECT_EQ(holes[0].cells, 2U);
    EXPECT_EQ(holes[1].first_cell, 12U);
    EXPECT_EQ(holes[1].cells, 3U);
}

TEST(HolesOf, AGridHangTogetherOverCorners) {
    EXPECT_EQ(holes_of(grid_of({"xxxxx", "x.xxx", "xx.xx", "xxx.x", "xxxxx"})).size(), 1U);
    EXPECT_TRUE(holes_of(grid_of({".xxxx", "x.xxx", "xx.xx", "xxx.x", "xxxxx"})).empty());
}

/// A rim of heights makes holes of all cells without one.
TEST(HolesOf, AFramedGridAreAllItsCellsWithoutValue) {
    EXPECT_TRUE(rc::check([] {
        const auto inner = *rc::gen::container<std::vector<bool>>(36, rc::gen::arbitrary<bool>());
        std::vector<std::string> rows(8, std::string(8, 'x'));
        std::size_t missing = 0;
        for (std::size_t i = 0; i < inner.size(); ++i) {
            rows[1 + i / 6][1 + i % 6] = inner[i] ? 'x' : '.';
            missing += inner[i] ? 0U : 1U;
        }
        const std::vector<Hole> holes = holes_of(grid_of(rows));
        const std::size_t found =
            std::accumulate(holes.begin(), holes.end(), std::size_t{0},
                            [](std::size_t sum, const Hole& hole) { return sum + hole.cells; });
        RC_ASSERT(found == missing);
    }));
}

}  // namespace
}  // namespace config::holes_test
