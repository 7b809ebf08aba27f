#include "coupling/assessments/consequences/presence.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "config/random/stream.hpp"

namespace coupling::consequences::presence_test {
namespace {

TEST(Presence, IsTheTimeThatVehiclesSpendInTheWayOfABlock) {
    // 1200 vehicles of 4.5 m at 60 km/h: each is within a width of 0.5 m for 5 m / (60 km/h) = 0.3 s, all of
    // them for 360 s of the 86 400 s of a day.
    EXPECT_NEAR(vehicles_in_the_way(1200.0, 4.5, 0.5, 60.0), 360.0 / 86400.0, 1e-15);
    EXPECT_DOUBLE_EQ(share_of_day(6.0), 0.25);
}

/// Vehicles pass one behind the other at equal gaps, blocks fall at random times: how many are hit.
TEST(Presence, IsTheShareOfBlocksThatHitPassingVehicles) {
    constexpr double vehicles_per_day = 4000.0;
    constexpr double length_m = 6.0;
    constexpr double diameter_m = 2.0;
    constexpr double speed_kmph = 30.0;
    constexpr double hours = 24.0;
    constexpr double seconds_of_an_hour = 3600.0;
    constexpr double speed_mps = speed_kmph * 1000.0 / seconds_of_an_hour;
    constexpr double gap_s = hours * seconds_of_an_hour / vehicles_per_day;
    constexpr int blocks = 200'000;
    config::RandomStream stream{{.seed = 1}, config::Purpose::sampling};
    int hits = 0;
    for (int i = 0; i < blocks; ++i) {
        const double falls_s = stream.uniform() * hours * seconds_of_an_hour;
        // The front of the last vehicle that came to the near edge of the block's way at 0 m.
        const double front_m = std::fmod(falls_s, gap_s) * speed_mps;
        hits += front_m - length_m < diameter_m ? 1 : 0;
    }
    const double expected = vehicles_in_the_way(vehicles_per_day, length_m, diameter_m, speed_kmph);
    EXPECT_NEAR(static_cast<double>(hits) / blocks, expected,
                4.0 * std::sqrt(expected * (1.0 - expected) / blocks));
}

RC_GTEST_PROP(Presence, RisesWithTrafficLengthAndBlockAndFallsWithSpeed, ()) {
    const auto positive = [] { return static_cast<double>(*rc::gen::inRange(1, 10'000)) / 10.0; };
    const double vehicles = positive();
    const double length_m = positive();
    const double block_m = positive();
    const double speed_kmph = positive();
    const double more = positive();
    const double now = vehicles_in_the_way(vehicles, length_m, block_m, speed_kmph);
    RC_ASSERT(vehicles_in_the_way(vehicles + more, length_m, block_m, speed_kmph) > now);
    RC_ASSERT(vehicles_in_the_way(vehicles, length_m + more, block_m, speed_kmph) > now);
    RC_ASSERT(vehicles_in_the_way(vehicles, length_m, block_m + more, speed_kmph) > now);
    RC_ASSERT(vehicles_in_the_way(vehicles, length_m, block_m, speed_kmph + more) < now);
}

}  // namespace
}  // namespace coupling::consequences::presence_test
