#include "rockfall/terrain/hilbert.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace rockfall::hilbert_test {
namespace {

using Place = std::pair<std::uint32_t, std::uint32_t>;

/// The cells of the lower left square of the given side, by their place along the curve.
std::map<std::uint32_t, Place> curve_through(std::uint32_t side) {
    std::map<std::uint32_t, Place> cells;
    for (std::uint32_t row = 0; row < side; ++row) {
        for (std::uint32_t column = 0; column < side; ++column) {
            cells[hilbert_index(column, row)] = {column, row};
        }
    }
    return cells;
}

TEST(HilbertIndex, VisitsEveryCellOfACornerSquareOnceAndFirst) {
    for (const std::uint32_t side : {2U, 8U, 64U}) {
        const std::map<std::uint32_t, Place> curve = curve_through(side);
        EXPECT_EQ(curve.size(), side * side);
        EXPECT_EQ(curve.rbegin()->first, side * side - 1);
    }
}

TEST(HilbertIndex, StepsFromCellToNeighbouringCell) {
    const std::map<std::uint32_t, Place> curve = curve_through(64);
    for (auto here = curve.begin(), next = std::next(here); next != curve.end(); ++here, ++next) {
        const int columns =
            std::abs(static_cast<int>(next->second.first) - static_cast<int>(here->second.first));
        const int rows =
            std::abs(static_cast<int>(next->second.second) - static_cast<int>(here->second.second));
        EXPECT_EQ(columns + rows, 1) << "at " << here->first;
    }
}

TEST(HilbertIndex, EndsInTheOtherLowerCorner) {
    EXPECT_EQ(hilbert_index(0, 0), 0U);
    EXPECT_EQ(hilbert_index(hilbert_side - 1, 0), 0xFFFFFFFFU);
}

RC_GTEST_PROP(HilbertOrder, NamesEveryPointOnce, (const std::vector<std::pair<int, int>>& places)) {
    std::vector<Eigen::Vector2d> points;
    for (const auto& [x, y] : places) {
        points.emplace_back(x, y);
    }
    std::vector<std::uint32_t> order = hilbert_order(points);
    std::sort(order.begin(), order.end());
    std::vector<std::uint32_t> all(points.size());
    std::iota(all.begin(), all.end(), 0U);
    RC_ASSERT(order == all);
}

TEST(HilbertOrder, KeepsTheOrderOfPointsInOnePlace) {
    const std::vector<Eigen::Vector2d> points(5, Eigen::Vector2d{3.0, 4.0});
    EXPECT_EQ(hilbert_order(points), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
}

TEST(HilbertOrder, StretchesTheCurveOverTheExtent) {
    // The four quadrants in the order of the curve: lower left, upper left, upper right, lower right.
    const std::vector<Eigen::Vector2d> points = {{1100, 900}, {1000, 1000}, {1100, 1000}, {1000, 900}};
    EXPECT_EQ(hilbert_order(points), (std::vector<std::uint32_t>{3, 1, 2, 0}));
}

}  // namespace
}  // namespace rockfall::hilbert_test
