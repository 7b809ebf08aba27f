#include "coupling/results/report/map/map_window.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace coupling::report::map_window_test {
namespace {

const config::GridFrame frame{100, 80, 1000.0, 2000.0, 5.0, 5.0};

MapWindow around(int west, int north, int east, int south, int least = 10) {
    return window_around(
        frame,
        [=](config::Cell cell) {
            return cell.column >= west && cell.column <= east && cell.row >= north && cell.row <= south;
        },
        least);
}

TEST(WindowAround, HoldsAllCellsThatCountAndAMargin) {
    // 41 columns, 21 rows: the margin is a twentieth of 40, two cells.
    EXPECT_EQ(around(20, 30, 60, 50), (MapWindow{18, 28, 45, 25}));
}

TEST(WindowAround, StaysOnTheMapAndIsNeverTiny) {
    rc::check([] {
        const int west = *rc::gen::inRange(0, frame.columns);
        const int north = *rc::gen::inRange(0, frame.rows);
        const int east = *rc::gen::inRange(west, frame.columns);
        const int south = *rc::gen::inRange(north, frame.rows);
        const MapWindow window = around(west, north, east, south);
        RC_ASSERT(window.column >= 0 && window.column <= west);
        RC_ASSERT(window.row >= 0 && window.row <= north);
        RC_ASSERT(window.column + window.columns > east && window.column + window.columns <= frame.columns);
        RC_ASSERT(window.row + window.rows > south && window.row + window.rows <= frame.rows);
        RC_ASSERT(window.columns >= 10 && window.rows >= 10);
    });
}

TEST(WindowAround, IsTheWholeMapWhereNoCellCounts) {
    EXPECT_EQ(window_around(frame, [](config::Cell) { return false; }), whole_of(frame));
}

TEST(PartOf, KeepsEachCellAtItsPlace) {
    config::Raster<float> raster{frame};
    for (std::size_t i = 0; i < raster.values.size(); ++i) {
        raster.values[i] = static_cast<float>(i);
    }
    const config::Raster<float> part = part_of(raster, {7, 11, 30, 20});
    for (std::size_t i = 0; i < part.values.size(); ++i) {
        const config::Cell cell = part.frame.cell_of(i);
        const double x_m = part.frame.x_centre_m(cell.column);
        const double y_m = part.frame.y_centre_m(cell.row);
        EXPECT_EQ(part.values[i], raster.at(frame.cell_at(x_m, y_m)));
    }
}

}  // namespace
}  // namespace coupling::report::map_window_test
