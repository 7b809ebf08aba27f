#include "coupling/assessments/hazard/forest_changes.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace coupling::hazard::forest_changes_test {
namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();

RuledLevel by(Level level, double rocks) {
    return {.level = level, .energy = {}, .rocks = rocks};
}

HazardMap map_of(const config::GridFrame& frame, const std::vector<float>& levels,
                 const std::vector<float>& rocks) {
    const config::Raster<float> empty{frame, none};
    HazardMap map{HazardRule::release, empty, empty, empty, {}, {}};
    map.level.values = levels;
    map.rocks.values = rocks;
    return map;
}

/// Six cells of 100 m2: one lowered from high to none, one raised from none to low, one equal, one that
/// nothing reaches, and two that differ by four rocks.
TEST(ForestChanges, CountTargetsAndAreasBothWays) {
    const config::GridFrame frame{.columns = 6,
                                  .rows = 1,
                                  .x_west_m = 0.0,
                                  .y_south_m = 0.0,
                                  .cell_width_m = 10.0,
                                  .cell_height_m = 10.0};
    const HazardMap bare =
        map_of(frame, {4.0F, none, 3.0F, none, 4.0F, 1.0F}, {5.0F, none, 90.0F, none, 4.0F, 900.0F});
    const HazardMap forest =
        map_of(frame, {none, 2.0F, 3.0F, none, 1.0F, 3.0F}, {none, 6.0F, 1.0F, none, 90.0F, 4.0F});
    const std::vector<RuledLevel> with_forest{by(Level::low, 1), by(Level::high, 5), by(Level::moderate, 3),
                                              by(Level::high, 4)};
    const std::vector<RuledLevel> without{by(Level::high, 5), by(Level::moderate, 1), by(Level::moderate, 1),
                                          by(Level::none, 0)};
    const ForestChanges changes = changes_between(with_forest, without, forest, bare);
    EXPECT_EQ(changes.lowered_targets, 1U);
    EXPECT_EQ(changes.raised_targets, 1U);
    EXPECT_EQ(changes.unclear_targets, 1U);
    EXPECT_DOUBLE_EQ(changes.all_lowered_ha(), 0.01);
    EXPECT_DOUBLE_EQ(changes.all_raised_ha(), 0.01);
    EXPECT_DOUBLE_EQ(changes.all_unclear_ha(), 0.02);
    EXPECT_DOUBLE_EQ(changes.lowered_ha[static_cast<std::size_t>(Level::none)], 0.01);
    EXPECT_DOUBLE_EQ(changes.raised_ha[static_cast<std::size_t>(Level::low)], 0.01);
    EXPECT_TRUE(changes.raises());
    EXPECT_FALSE(changes_between(without, without, bare, bare).raises());
    EXPECT_DOUBLE_EQ(chance_area_ha(bare, Level::high), 0.01);
    EXPECT_DOUBLE_EQ(chance_area_ha(forest, Level::moderate), 0.02);
}

/// What differs is lower, higher or unclear, and the other way round the opposite; rocks that are not counted
/// are no chance.
TEST(ForestChanges, AreOppositeTheOtherWayRound) {
    for (const Level level : {Level::none, Level::low, Level::high}) {
        for (const Level other : {Level::none, Level::low, Level::high}) {
            for (const double rocks : {0.0, 1.0, 4.0, 5.0, 100.0}) {
                for (const double other_rocks : {0.0, 1.0, 4.0, 5.0, 100.0}) {
                    const ForestChange there = change_between(by(level, rocks), by(other, other_rocks));
                    const ForestChange back = change_between(by(other, other_rocks), by(level, rocks));
                    EXPECT_EQ(there == ForestChange::none, level == other);
                    EXPECT_EQ(there == ForestChange::unclear, back == ForestChange::unclear);
                    EXPECT_EQ(there == ForestChange::raises, back == ForestChange::lowers);
                    const double of_higher = level > other ? rocks : other_rocks;
                    EXPECT_EQ(there == ForestChange::unclear,
                              level != other && of_higher > 0.0 && of_higher < 5.0);
                }
            }
        }
    }
}

}  // namespace
}  // namespace coupling::hazard::forest_changes_test
