#include "coupling/inputs/plausible/outline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/coupling/inputs/plausible/turned.hpp"

namespace coupling::plausible::outline_test {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

config::Raster<double> whole(int columns, int rows) {
    config::GridFrame frame;
    frame.columns = columns;
    frame.rows = rows;
    return config::Raster<double>{frame, 1.0};
}

/// Cells that are known with a probability, whatever lies beside them.
config::Raster<double> scattered(int side, double known, std::mt19937& random) {
    config::Raster<double> cells = whole(side, side);
    for (double& value : cells.values) {
        value = std::generate_canonical<double, 32>(random) < known ? 1.0 : unknown;
    }
    return cells;
}

TEST(Outline, OfAWholeGridGoesAlongItsOuterCells) {
    const Outline outline = outline_of(whole(12, 10));
    EXPECT_DOUBLE_EQ(outline.area_m2, 11.0 * 9.0);
    EXPECT_EQ(outline.unknown, 0.0);
}

TEST(Outline, GoesRoundScatteredCellsAtAnyDensity) {
    std::mt19937 random{7};
    for (const double known : {0.9, 0.5, 0.3, 0.1, 0.03}) {
        const Outline outline = outline_of(scattered(120, known, random));
        // All cells but some at the rim: 120 x 120 cells make 119 x 119 squares.
        EXPECT_GT(outline.area_m2, 0.85 * 119.0 * 119.0) << known;
        EXPECT_LE(outline.area_m2, 119.0 * 119.0) << known;
        EXPECT_NEAR(outline.unknown, 1.0 - known, 0.05) << known;
    }
}

TEST(Outline, HasNothingUnknownInAPartOfAGrid) {
    // An L and a strip that crosses the grid aslant, as valleys are cut out: nothing is missing in either.
    config::Raster<double> corner = whole(60, 50);
    config::Raster<double> strip = whole(60, 60);
    for (std::size_t i = 0; i < corner.values.size(); ++i) {
        const config::Cell cell = corner.frame.cell_of(i);
        corner.values[i] = cell.column > 25 && cell.row < 20 ? unknown : 1.0;
    }
    for (std::size_t i = 0; i < strip.values.size(); ++i) {
        const config::Cell cell = strip.frame.cell_of(i);
        strip.values[i] = std::abs(cell.column - cell.row) > 12 ? unknown : 1.0;
    }
    EXPECT_EQ(outline_of(corner).unknown, 0.0);
    EXPECT_LT(outline_of(strip).unknown, 0.005);
}

TEST(Outline, EnclosesALake) {
    config::Raster<double> cells = whole(40, 40);
    for (int row = 12; row < 28; ++row) {
        for (int column = 12; column < 28; ++column) {
            cells.at({column, row}) = unknown;
        }
    }
    EXPECT_DOUBLE_EQ(outline_of(cells).unknown, 16.0 * 16.0 / (40.0 * 40.0));
}

TEST(Outline, IsTheSameForATurnedAndMirroredGrid) {
    std::mt19937 random{3};
    for (int trial = 0; trial < 20; ++trial) {
        const config::Raster<double> cells = scattered(30, 0.05 * (trial + 1), random);
        const Outline straight = outline_of(cells);
        for (const Turn turn : all_turns()) {
            const Outline turned = outline_of(turn.of(cells));
            EXPECT_DOUBLE_EQ(turned.area_m2, straight.area_m2) << trial;
            EXPECT_DOUBLE_EQ(turned.unknown, straight.unknown) << trial;
        }
    }
}

}  // namespace
}  // namespace coupling::plausible::outline_test
