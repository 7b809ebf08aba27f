#include "coupling/inputs/observed/stops.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace coupling::observed {
namespace {

/// Rocks of two zones: zone 1 runs 10 and 20 m to the east, zone 2 100 m to the north.
std::vector<SimulatedStop> two_zones() {
    return {{{0.0, 0.0}, {10.0, 0.0}, 1, false},
            {{0.0, 0.0}, {20.0, 0.0}, 1, true},
            {{50.0, 0.0}, {50.0, 100.0}, 2, false}};
}

TEST(CompareStops, HoldsAGroupAgainstTheRocksOfItsZones) {
    const std::vector<ObservedStop> observed{{{12.0, 5.0}, Eigen::Vector2d{0.0, 0.0}, 1, "a"},
                                             {{12.0, -5.0}, Eigen::Vector2d{0.0, 0.0}, 1, "a"},
                                             {{50.0, 80.0}, std::nullopt, 2, "b"}};
    const auto comparisons = compare_stops(observed, two_zones());
    ASSERT_EQ(comparisons.size(), 3U);
    EXPECT_EQ(comparisons[0].group, "");
    EXPECT_EQ(comparisons[0].observed.rocks, 3U);
    EXPECT_EQ(comparisons[0].simulated.rocks, 3U);

    const StopComparison& a = comparisons[1];
    EXPECT_EQ(a.group, "a");
    EXPECT_DOUBLE_EQ(a.observed.mean_m, 13.0);
    EXPECT_NEAR(a.observed.sideways_m, std::sqrt(50.0), 1e-12);
    EXPECT_DOUBLE_EQ(a.simulated.mean_m, 15.0);
    EXPECT_DOUBLE_EQ(a.simulated.sideways_m, 0.0);
    EXPECT_DOUBLE_EQ(a.simulated.left_terrain, 0.5);
    EXPECT_DOUBLE_EQ(a.largest_distance, 0.5);

    const StopComparison& b = comparisons[2];
    EXPECT_DOUBLE_EQ(b.observed.mean_m, 80.0) << "measured from where the rocks of zone 2 start";
    EXPECT_DOUBLE_EQ(b.simulated.mean_m, 100.0);
    EXPECT_DOUBLE_EQ(b.energy_distance_m, 40.0);
}

TEST(CompareStops, WithoutZonesTakesAllRocks) {
    const auto comparisons = compare_stops(std::vector<ObservedStop>{{{10.0, 0.0}, {}, {}, ""}}, two_zones());
    ASSERT_EQ(comparisons.size(), 1U);
    EXPECT_EQ(comparisons[0].simulated.rocks, 3U);
}

TEST(CompareStops, OfNoRocksIsEmpty) {
    EXPECT_TRUE(compare_stops(std::vector<ObservedStop>{{{10.0, 0.0}, {}, {}, ""}}, {}).empty());
    EXPECT_TRUE(compare_stops({}, two_zones()).empty());
}

}  // namespace
}  // namespace coupling::observed
