#include "coupling/assessments/profile/falls/profile_tally.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/coupling/assessments/profile/profile_project.hpp"

namespace coupling::profile::profile_tally_test {
namespace {

TEST(Moments, AreThoseOfAllNumbersTogether) {
    Moments moments;
    EXPECT_TRUE(std::isnan(moments.mean()) && std::isnan(moments.least()) && std::isnan(moments.deviation()));
    for (const double value : {1e6 + 4.0, 1e6 + 7.0, 1e6 + 13.0, 1e6 + 16.0}) {
        moments.add(value);
    }
    EXPECT_EQ(moments.count(), 4U);
    EXPECT_DOUBLE_EQ(moments.mean(), 1e6 + 10.0);
    EXPECT_NEAR(moments.deviation(), std::sqrt(30.0), 1e-9);
    EXPECT_EQ(moments.least(), 1e6 + 4.0);
    EXPECT_EQ(moments.most(), 1e6 + 16.0);
}

/// A site of 100 m at 45 degrees, with a station at 50 m.
struct EvenSite {
    ProfileSite site;
    EvenSite()
        : site{{{0.0, 100.0, 0}, {100.0, 0.0, 0}},
               rockfall::strip_slope(std::vector<rockfall::ProfilePoint>{{0.0, 100.0, 0}, {100.0, 0.0, 0}},
                                     {{}}),
               0.0,
               {{"middle", 50.0}},
               nullptr,
               {}} {}
};

rockfall::Jump jump_to(double from_m, double to_m, bool landed = true) {
    rockfall::Jump jump;
    jump.from_m = {from_m, 0.0, 100.0 - from_m};
    jump.to_m = {to_m, 0.0, 100.0 - to_m};
    jump.impact_mps = 7.0;
    jump.landed = landed;
    return jump;
}

WatchedFall fall_to(double end_m, rockfall::StopReason reason) {
    WatchedFall fall;
    fall.started = true;
    fall.record.end_m = {end_m, 0.0, 100.0 - end_m};
    fall.record.reason = reason;
    fall.arrivals.resize(1);
    return fall;
}

TEST(ProfileTally, PutsAJumpWhereItEndsAlongTheSlope) {
    const EvenSite even;
    ProfileTally tally{even.site, 10.0};
    ASSERT_EQ(tally.segments.size(), 15U);  // 141.4 m of slope
    WatchedFall fall = fall_to(60.0, rockfall::StopReason::at_rest);
    // Ends at 28.3 m and 29.7 m of slope length; the first flight comes from the release.
    fall.jumps = {jump_to(0.0, 5.0), jump_to(5.0, 20.0), jump_to(20.0, 21.0), jump_to(21.0, 21.0),
                  jump_to(21.0, 100.0, false)};
    tally.add(even.site, fall, true);
    EXPECT_EQ(tally.jump_length_m.count(), 2U);
    const Moments& length_m = tally.segments[2].length_m;
    EXPECT_EQ(length_m.count(), 2U);
    EXPECT_DOUBLE_EQ(length_m.least(), std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(length_m.most(), 15.0 * std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(tally.segments[2].impact_mps.mean(), 7.0);
    tally.add(even.site, fall, false);  // a rolling start: the first jump too counts
    EXPECT_EQ(tally.segments[0].length_m.count(), 1U);
}

TEST(ProfileTally, CountsEndsBeyondEachDistance) {
    const EvenSite even;
    ProfileTally tally{even.site, 10.0};
    ASSERT_EQ(tally.stretch_m, 1.0);
    using rockfall::StopReason;
    tally.add(even.site, fall_to(30.5, StopReason::at_rest), false);
    tally.add(even.site, fall_to(70.0, StopReason::caught), false);
    tally.add(even.site, fall_to(100.0, StopReason::left_terrain), false);
    tally.add(even.site, fall_to(0.0, StopReason::left_terrain), false);
    EXPECT_EQ(tally.ended_beyond(0), 4U);
    EXPECT_EQ(tally.ended_beyond(1), 3U);  // one left over the upper end
    EXPECT_EQ(tally.ended_beyond(31), 2U);
    EXPECT_EQ(tally.ended_beyond(70), 2U);
    EXPECT_EQ(tally.ended_beyond(71), 1U);
    EXPECT_EQ(tally.ended_beyond(100), 1U);
}

TEST(ProfileTally, TakesStationsFromArrivals) {
    const EvenSite even;
    ProfileTally tally{even.site, 10.0};
    WatchedFall fall = fall_to(80.0, rockfall::StopReason::at_rest);
    for (const float energy_j : {100e3F, 300e3F}) {
        fall.arrivals[0] = {true, false, 50.0F, 0.0F, energy_j, 0.8F * energy_j, 12.0F, 0.5F};
        tally.add(even.site, fall, false);
    }
    fall.arrivals[0] = {};
    tally.add(even.site, fall, false);
    const StationTally& station = tally.stations[0];
    EXPECT_EQ(station.energy_j.moments.count(), 2U);
    EXPECT_DOUBLE_EQ(station.energy_j.moments.mean(), 200e3);
    EXPECT_NEAR(station.translational_j.mean(), 160e3, 0.1);
    // Of two rocks only the median is known.
    EXPECT_NEAR(station.energy_j.quantile(rockfall::fine_energy_bins, 0.5), 100e3, 0.01 * 100e3);
    EXPECT_TRUE(std::isnan(station.energy_j.quantile(rockfall::fine_energy_bins, 0.95)));
    for (int rock = 0; rock < 18; ++rock) {
        fall.arrivals[0] = {true, false, 50.0F, 0.0F, 300e3F, 240e3F, 12.0F, 0.5F};
        tally.add(even.site, fall, false);
    }
    EXPECT_NEAR(station.energy_j.quantile(rockfall::fine_energy_bins, 0.95), 300e3, 0.01 * 300e3);
    EXPECT_DOUBLE_EQ(station.speed_mps.moments.mean(), 12.0);
}

}  // namespace
}  // namespace coupling::profile::profile_tally_test
