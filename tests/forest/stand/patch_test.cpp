#include "forest/stand/patch.hpp"

#include <gtest/gtest.h>

namespace forest::patch_test {
namespace {

const config::GridFrame frame{.columns = 3,
                              .rows = 2,
                              .x_west_m = 100.0,
                              .y_south_m = 200.0,
                              .cell_width_m = 10.0,
                              .cell_height_m = 10.0};

TEST(PatchGrid, OrdersPatchesFromTheNorthWestHoweverTheyAreGiven) {
    std::vector<Patch> patches(3);
    patches[0].cell = {2, 1};
    patches[1].cell = {0, 1};
    patches[2].cell = {1, 0};
    const PatchGrid grid{frame, patches};
    EXPECT_EQ(grid.patches()[0].cell, (config::Cell{1, 0}));
    EXPECT_EQ(grid.patches()[2].cell, (config::Cell{2, 1}));
    EXPECT_DOUBLE_EQ(grid.area_ha(), 0.03);
}

TEST(PatchGrid, HasNoPatchOnCellsWithoutForestAndBeyondTheFrame) {
    std::vector<Patch> patches(1);
    patches[0].cell = {1, 0};
    const PatchGrid grid{frame, patches};
    EXPECT_EQ(grid.at(115.0, 215.0), PatchId{0});
    EXPECT_FALSE(grid.at(105.0, 215.0));
    EXPECT_FALSE(grid.at(99.0, 215.0));
    EXPECT_FALSE(grid.at(config::Cell{1, 2}));
}

TEST(PatchGrid, KnowsTheCentreOfAPatch) {
    std::vector<Patch> patches(1);
    patches[0].cell = {1, 0};
    const PatchGrid grid{frame, patches};
    EXPECT_DOUBLE_EQ(grid.x_centre_m(PatchId{0}), 115.0);
    EXPECT_DOUBLE_EQ(grid.y_centre_m(PatchId{0}), 215.0);
}

}  // namespace
}  // namespace forest::patch_test
