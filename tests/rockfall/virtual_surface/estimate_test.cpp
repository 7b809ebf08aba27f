#include "rockfall/virtual_surface/estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace rockfall::estimate_test {
namespace {

TEST(StopProbability, HasTheErrorOfTheDifferencesBetweenSurfaces) {
    // Shares 0.1 and 0.3: mean 0.2, variance of the mean (0.01 + 0.01) / (2 * 1).
    const std::vector<ThrowTally> two{{100'000, 0, 10'000}, {100'000, 0, 30'000}};
    EXPECT_DOUBLE_EQ(stop_probability(two).value, 0.2);
    EXPECT_NEAR(stop_probability(two).standard_error, 0.1, 1e-12);
}

TEST(StopProbability, HasAtLeastTheErrorOfItsThrows) {
    const std::vector<ThrowTally> alike{{400, 0, 100}, {400, 0, 100}, {400, 0, 100}, {400, 0, 100}};
    EXPECT_NEAR(stop_probability(alike).standard_error, std::sqrt(0.25 * 0.75 / 1600.0), 1e-4);
    const std::vector<ThrowTally> none{{1000, 0, 0}, {1000, 0, 0}};
    EXPECT_EQ(stop_probability(none).value, 0.0);
    EXPECT_NEAR(stop_probability(none).standard_error, 1.0 / 2000.0, 1e-5);
}

TEST(RollingStops, AreStopsPerMetreOverAllSurfaces) {
    const std::vector<RollTally> two{{100, 10, 1000.0}, {100, 30, 1000.0}};
    EXPECT_DOUBLE_EQ(rolling_stops_per_m(two).value, 0.02);
    // (2 / 1) * (10^2 + 10^2) = 400 = 20^2 above the 41 of the stops alone
    EXPECT_NEAR(rolling_stops_per_m(two).standard_error, 20.0 / 2000.0, 1e-12);
    const std::vector<RollTally> none{{100, 0, 2400.0}};
    EXPECT_NEAR(rolling_stops_per_m(none).standard_error, 1.0 / 2400.0, 1e-12);
}

TEST(StopProbability, CoversTheTruthAsOftenAsItSays) {
    // Known truth: surfaces with shares drawn evenly from 0.1 to 0.3. Two standard errors of 16 surfaces hold
    // the mean in 93.6 % of cases (Student, 15 degrees of freedom).
    constexpr int trials = 2000;
    int held = 0;
    for (std::uint32_t trial = 0; trial < trials; ++trial) {
        std::vector<ThrowTally> tallies;
        for (std::uint64_t surface = 0; surface < 16; ++surface) {
            config::RandomStream stream{{3, trial, 0, surface}, config::Purpose::test};
            const double share = 0.1 + 0.2 * stream.uniform();
            ThrowTally tally{100, 0, 0};
            for (int i = 0; i < 100; ++i) {
                tally.stopped += stream.uniform() < share ? 1U : 0U;
            }
            tallies.push_back(tally);
        }
        const SurfaceEstimate estimate = stop_probability(tallies);
        held += std::abs(estimate.value - 0.2) < 2.0 * estimate.standard_error ? 1 : 0;
    }
    EXPECT_NEAR(held / static_cast<double>(trials), 0.936, 4.0 * std::sqrt(0.936 * 0.064 / trials));
}

}  // namespace
}  // namespace rockfall::estimate_test
