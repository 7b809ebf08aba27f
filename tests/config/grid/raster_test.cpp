#include "config/grid/raster.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace config::raster_test {
namespace {

const GridFrame frame{
    .columns = 4, .rows = 3, .x_west_m = 100.0, .y_south_m = 50.0, .cell_width_m = 2.0, .cell_height_m = 5.0};

TEST(GridFrame, FindsEachCellAtItsCentre) {
    for (std::size_t index = 0; index < frame.size(); ++index) {
        const Cell cell = frame.cell_of(index);
        EXPECT_EQ(frame.index(cell), index);
        EXPECT_EQ(frame.cell_at(frame.x_centre_m(cell.column), frame.y_centre_m(cell.row)), cell);
    }
}

TEST(GridFrame, SpansCountsTimesCellSize) {
    EXPECT_EQ(frame.x_east_m(), 108.0);
    EXPECT_EQ(frame.y_north_m(), 65.0);
    EXPECT_EQ(frame.cell_area_m2(), 10.0);
}

RC_GTEST_PROP(GridFrame, CoversJustThePointsOfItsCells, ()) {
    const double x_m = 95.0 + 0.25 * *rc::gen::inRange(0, 80);
    const double y_m = 45.0 + 0.25 * *rc::gen::inRange(0, 100);
    RC_ASSERT(frame.covers(x_m, y_m) == frame.contains(frame.cell_at(x_m, y_m)));
}

TEST(SamePlace, ForgivesAHundredthOfACell) {
    GridFrame other = frame;
    other.x_west_m += 0.015;
    EXPECT_TRUE(same_place(frame, other));
    other.x_west_m += 0.01;
    EXPECT_FALSE(same_place(frame, other));
    other = frame;
    other.cell_width_m += 0.01;  // adds up over four columns
    EXPECT_FALSE(same_place(frame, other));
}

}  // namespace
}  // namespace config::raster_test
