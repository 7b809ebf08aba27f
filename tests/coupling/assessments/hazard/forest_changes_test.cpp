#include "coupling/assessments/hazard/forest_changes.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace coupling::hazard::forest_changes_test {
namespace {

/// Four cells of 100 m2: one lowered from high to none, one raised from none to low, one equal, one that
/// nothing reaches.
TEST(ForestChanges, CountTargetsAndAreasBothWays) {
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    const config::GridFrame frame{.columns = 4,
                                  .rows = 1,
                                  .x_west_m = 0.0,
                                  .y_south_m = 0.0,
                                  .cell_width_m = 10.0,
                                  .cell_height_m = 10.0};
    config::Raster<float> forest{frame, none};
    config::Raster<float> bare{frame, none};
    bare.values = {4.0F, none, 3.0F, none};
    forest.values = {none, 2.0F, 3.0F, none};
    const std::vector<Level> with_forest{Level::low, Level::high, Level::moderate};
    const std::vector<Level> without{Level::high, Level::moderate, Level::moderate};
    const ForestChanges changes = changes_between(with_forest, without, forest, bare);
    EXPECT_EQ(changes.lowered_targets, 1U);
    EXPECT_EQ(changes.raised_targets, 1U);
    EXPECT_DOUBLE_EQ(changes.all_lowered_ha(), 0.01);
    EXPECT_DOUBLE_EQ(changes.all_raised_ha(), 0.01);
    EXPECT_DOUBLE_EQ(changes.lowered_ha[static_cast<std::size_t>(Level::none)], 0.01);
    EXPECT_DOUBLE_EQ(changes.raised_ha[static_cast<std::size_t>(Level::low)], 0.01);
    EXPECT_TRUE(changes.raises());
    EXPECT_FALSE(changes_between(without, without, bare, bare).raises());
}

}  // namespace
}  // namespace coupling::hazard::forest_changes_test
