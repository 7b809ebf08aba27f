#include "coupling/program/actions/pilot.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "coupling/program/actions/estimate.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::pilot_test {
namespace {

/// A clock that a test can know: each look at it takes some time.
struct Clock {
    double step_s;
    double now_s = 0.0;
    int looks = 0;

    double operator()() {
        ++looks;
        return now_s += step_s;
    }
};

double pilot_with(Clock& clock, const std::string& rocks) {
    const SampleProject project;
    const Opened opened =
        open(project, {"rockfall.motion=rigid", "release.shape=cube", "release.rocks=" + rocks});
    EXPECT_TRUE(opened.site) << opened.errors;
    return opened.site ? pilot_seconds_per_rock(*opened.scenario, *opened.site, std::ref(clock)) : 0.0;
}

TEST(Pilot, EndsAfterASecondWithTheMeanOfItsRocks) {
    Clock clock{0.125};  // of a power of two: sums are exact
    // Before the first rock, after each from the eighth on until a second has passed, and at the end.
    EXPECT_DOUBLE_EQ(pilot_with(clock, "40"), (8 + 1) * 0.125 / 15);
    EXPECT_EQ(clock.looks, 1 + 8 + 1);
}

TEST(Pilot, SeesAFewRocksHoweverSlowTheyAre) {
    Clock clock{4.0};
    EXPECT_DOUBLE_EQ(pilot_with(clock, "40"), 2 * 4.0 / 8);
}

TEST(Pilot, EndsWithTheLastRock) {
    Clock clock{0.125};
    EXPECT_DOUBLE_EQ(pilot_with(clock, "4"), 0.125 / 4);
    EXPECT_EQ(clock.looks, 2);
}

TEST(Pilot, SetsTheEstimateWhereTheModelHasNoKnownSpeed) {
    const SampleProject project;
    const Opened opened = open(project, {"rockfall.motion=rigid", "release.shape=cube", "release.rocks=40"});
    ASSERT_TRUE(opened.site) << opened.errors;
    const auto seconds = [&](int threads, double pilot_s) {
        return estimate_of(*opened.scenario, *opened.site, threads,
                           [&](const Scenario&, const Site&) { return pilot_s; })
            .seconds;
    };
    EXPECT_DOUBLE_EQ(seconds(1, 0.25), 40 * 0.25);
    EXPECT_DOUBLE_EQ(seconds(8, 0.25), 40 * 0.25 / 8);
    EXPECT_DOUBLE_EQ(seconds(1, 0.5), 2 * seconds(1, 0.25));
}

}  // namespace
}  // namespace coupling::pilot_test
