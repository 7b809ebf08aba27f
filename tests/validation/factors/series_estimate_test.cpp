#include "validation/engine/factors/series_estimate.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "config/random/stream.hpp"

namespace coupling::validation::series_estimate_test {
namespace {

TEST(RatioOf, IsTheMeanWithItsTextbookIntervalWhereDenominatorsAreOne) {
    const std::array<double, 4> values{1.0, 2.0, 3.0, 4.0};
    const std::array<double, 4> ones{1.0, 1.0, 1.0, 1.0};
    const Estimate mean = ratio_of(values, ones).interval();
    EXPECT_DOUBLE_EQ(mean.value, 2.5);
    // s / sqrt(n) = sqrt(5/3) / 2; t(0.975, 3) = 3.18245.
    EXPECT_NEAR(mean.high - mean.value, 3.18245 * std::sqrt(5.0 / 3.0) / 2.0, 1e-5);
    EXPECT_NEAR(mean.value - mean.low, mean.high - mean.value, 1e-12);
}

TEST(RatioOf, IsExactWhereAllSeriesAgree) {
    const std::array<double, 3> part{1.0, 2.0, 4.0};
    const std::array<double, 3> whole{2.0, 4.0, 8.0};
    const Estimate ratio = ratio_of(part, whole).interval();
    EXPECT_DOUBLE_EQ(ratio.value, 0.5);
    EXPECT_NEAR(ratio.high, ratio.low, 1e-12);
}

TEST(RatioOf, NothingIsNotANumber) {
    const std::array<double, 2> zeros{0.0, 0.0};
    EXPECT_TRUE(std::isnan(ratio_of(zeros, zeros).value));
}

TEST(SeriesEstimate, OfOneSeriesKnowsNoInterval) {
    const std::array<double, 1> one{3.0};
    EXPECT_TRUE(std::isinf(ratio_of(one, one).interval().high));
}

TEST(Difference, OfFiguresThatSwingTogetherIsSurerThanEach) {
    const std::array<double, 4> ones{1.0, 1.0, 1.0, 1.0};
    const SeriesEstimate a = ratio_of(std::array{1.0, 5.0, 2.0, 8.0}, ones);
    const SeriesEstimate b = ratio_of(std::array{2.0, 6.0, 3.0, 9.0}, ones);
    const Estimate step = difference(b, a).interval();
    EXPECT_DOUBLE_EQ(step.value, 1.0);
    EXPECT_NEAR(step.high - step.low, 0.0, 1e-12);
    EXPECT_GT(a.interval().high - a.interval().low, 1.0);
}

TEST(OneMinus, KeepsTheWidth) {
    const std::array<double, 3> ones{1.0, 1.0, 1.0};
    const SeriesEstimate share = ratio_of(std::array{0.1, 0.2, 0.6}, ones);
    const Estimate before = share.interval();
    const Estimate after = one_minus(share).interval();
    EXPECT_DOUBLE_EQ(after.value, 1.0 - before.value);
    EXPECT_NEAR(after.low, 1.0 - before.high, 1e-12);
}

TEST(MeanOf, FiguresOfTheSameSeriesAddTheirPulls) {
    const std::array<double, 3> ones{1.0, 1.0, 1.0};
    const SeriesEstimate rising = ratio_of(std::array{1.0, 2.0, 3.0}, ones);
    const SeriesEstimate falling = ratio_of(std::array{3.0, 2.0, 1.0}, ones);
    const Estimate mean = mean_of(std::array{rising, falling}).interval();
    EXPECT_DOUBLE_EQ(mean.value, 2.0);
    EXPECT_NEAR(mean.high, 2.0, 1e-12) << "what one gains the other loses";
}

TEST(RatioOf, CoversTheTruthAsOftenAsItSays) {
    // Series of stands whose true share varies between 0.2 and 0.6, 40 rocks in each; the truth is 0.4.
    constexpr int trials = 2000;
    constexpr int series = 20;
    constexpr int rocks = 40;
    int covered = 0;
    for (int trial = 0; trial < trials; ++trial) {
        config::RandomStream stream{{.seed = 1, .id = static_cast<std::uint64_t>(trial)},
                                    config::Purpose::stand};
        std::vector<double> hits(series, 0.0);
        const std::vector<double> all(series, rocks);
        for (double& of_series : hits) {
            const double share = 0.2 + 0.4 * stream.uniform();
            for (int rock = 0; rock < rocks; ++rock) {
                of_series += stream.uniform() < share ? 1.0 : 0.0;
            }
        }
        const Estimate estimate = ratio_of(hits, all).interval();
        covered += estimate.low <= 0.4 && 0.4 <= estimate.high ? 1 : 0;
    }
    const double four_sigma = 4.0 * std::sqrt(0.95 * 0.05 / trials);
    EXPECT_NEAR(static_cast<double>(covered) / trials, 0.95, four_sigma);
}

}  // namespace
}  // namespace coupling::validation::series_estimate_test
