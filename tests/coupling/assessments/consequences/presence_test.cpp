#include "coupling/assessments/consequences/presence.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
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

/// Table 1 of M. J. Ellison, "Quantified tree risk assessment used in the management of amenity trees"
/// (auf.isa-arbor.com): how long vehicles occupy a point of a road, by the formula of vehicles_in_the_way()
/// for what falls onto it, with the stopping distance and a vehicle of 6 m. Its hours are cut off or rounded.
TEST(Presence, IsThatOfThePublishedTableOfRoads) {
    struct Road {
        double speed_kmph;
        double length_m;  ///< stopping distance and vehicle
        double seconds;   ///< of each vehicle
        double vehicles_per_day;
        double hours;   ///< of a day
        double one_in;  ///< probability of an impact: 1 in so many
    };
    constexpr double vehicle_m = 6.0;
    for (const Road& road :
         {Road{113.0, 102.0, 3.25, 30450.0, 27.5, 1.0}, Road{48.0, 29.0, 2.17, 19200.0, 11.5, 2.1},
          Road{64.0, 42.0, 2.36, 15500.0, 10.1, 2.4}, Road{48.0, 29.0, 2.17, 15000.0, 9.0, 2.7},
          Road{64.0, 42.0, 2.36, 7200.0, 4.7, 5.1}, Road{64.0, 42.0, 2.36, 1400.0, 0.9, 27.0}}) {
        const auto in_the_way = [&](double vehicles) {
            return vehicles_in_the_way(vehicles, vehicle_m, road.length_m - vehicle_m, road.speed_kmph);
        };
        EXPECT_NEAR(in_the_way(1.0) * 86400.0, road.seconds, 0.01);
        const double share = in_the_way(road.vehicles_per_day);
        EXPECT_NEAR(share * 24.0, road.hours, 0.1) << road.vehicles_per_day;
        EXPECT_NEAR(share, share_of_day(road.hours), 0.1 / 24.0);
        EXPECT_NEAR(1.0 / std::min(1.0, share), road.one_in, 0.04 * road.one_in) << road.vehicles_per_day;
    }
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
