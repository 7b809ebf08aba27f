#include "rockfall/terrain/vertical_error.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/rockfall/terrain/sample_slopes.hpp"

namespace rockfall::vertical_error_test {
namespace {

using config::Cell;

TEST(LargestVerticalError, IsThatOfTheOneCellThatSticksOut) {
    config::Raster<double> heights = tilted_grid(frame_of(9, 9));
    heights.at({2, 3}) += 1.5;
    const VerticalError worst = largest_vertical_error(heights, {Cell{0, 8}, Cell{8, 0}, Cell{0, 0}});
    EXPECT_NEAR(worst.error_m, 1.5, 1e-9);
    EXPECT_EQ(worst.cell, (Cell{2, 3}));
}

TEST(LargestVerticalError, CountsCellsOnTheEdgesButNotBeyond) {
    config::Raster<double> heights = tilted_grid(frame_of(9, 9));
    heights.at({5, 3}) -= 1.0;  // on the diagonal
    heights.at({5, 4}) -= 9.0;  // beyond it
    const VerticalError worst = largest_vertical_error(heights, {Cell{0, 8}, Cell{8, 0}, Cell{0, 0}});
    EXPECT_NEAR(worst.error_m, 1.0, 1e-9);
    EXPECT_EQ(worst.cell, (Cell{5, 3}));
}

TEST(LargestVerticalError, IsZeroWithoutACellBetweenTheCorners) {
    const config::Raster<double> heights = rough_grid(frame_of(3, 3), 0.3, 1);
    EXPECT_EQ(largest_vertical_error(heights, {Cell{0, 1}, Cell{1, 0}, Cell{0, 0}}).error_m, 0.0);
}

RC_GTEST_PROP(LargestVerticalError, EqualsATestOfEveryCell, ()) {
    const auto any = [] { return Cell{*rc::gen::inRange(0, 12), *rc::gen::inRange(0, 12)}; };
    const std::array<Cell, 3> corners{any(), any(), any()};
    const auto twice_area = [](Cell a, Cell b, Cell c) {
        return (b.column - a.column) * (c.row - a.row) - (b.row - a.row) * (c.column - a.column);
    };
    const auto [a, b, c] = corners;
    const int whole = twice_area(a, b, c);
    RC_PRE(whole != 0);
    const config::Raster<double> heights = rough_grid(frame_of(12, 12), 1.0, 5);

    double expected_m = 0.0;
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        const Cell p = heights.frame.cell_of(i);
        const double u = 1.0 * twice_area(p, b, c) / whole;
        const double v = 1.0 * twice_area(a, p, c) / whole;
        const double w = 1.0 * twice_area(a, b, p) / whole;
        if (u >= 0.0 && v >= 0.0 && w >= 0.0) {
            const double plane_m = u * heights.at(a) + v * heights.at(b) + w * heights.at(c);
            expected_m = std::max(expected_m, std::abs(heights.at(p) - plane_m));
        }
    }
    RC_ASSERT(std::abs(largest_vertical_error(heights, corners).error_m - expected_m) < 1e-9);
}

}  // namespace
}  // namespace rockfall::vertical_error_test
