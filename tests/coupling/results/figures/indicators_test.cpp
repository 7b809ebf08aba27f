#include "coupling/results/figures/indicators.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "config/random/stream.hpp"

namespace coupling::indicators_test {
namespace {

config::RandomStream stream_of(std::uint64_t trial) {
    return {config::StreamKey{7, 0, 0, trial}, config::Purpose::test};
}

/// How far a share of `trials` may lie from its expectation by chance: four standard deviations.
double four_sigma(double share, int trials) {
    return 4.0 * std::sqrt(share * (1.0 - share) / trials);
}

TEST(ShareOf, AgreesWithTheClosedFormWhereNoneOrAllAreHit) {
    // With none of n hit the exact upper limit is 1 - 0.025^(1/n).
    const Share none = share_of(0, 10);
    EXPECT_EQ(none.value, 0.0);
    EXPECT_EQ(none.interval.low, 0.0);
    EXPECT_NEAR(none.interval.high, 1.0 - std::pow(0.025, 0.1), 1e-12);
    const Share all = share_of(10, 10);
    EXPECT_NEAR(all.interval.low, std::pow(0.025, 0.1), 1e-12);
    EXPECT_EQ(all.interval.high, 1.0);
}

/// With this share none of the rocks arrives once in twenty times.
TEST(GreatestShareOfNone, IsOneSided) {
    for (const std::uint64_t rocks : {1U, 10U, 400U, 100'000U}) {
        const double share = greatest_share_of_none(rocks);
        EXPECT_NEAR(std::pow(1.0 - share, static_cast<double>(rocks)), 0.05, 1e-9) << rocks;
        EXPECT_LT(share, share_of(0, rocks).interval.high) << rocks;
    }
    EXPECT_NEAR(greatest_share_of_none(100'000), 3.0 / 100'000.0, 1e-7);  // rule of three
    EXPECT_EQ(greatest_share_of_none(0), 1.0);
}

TEST(ShareOf, OfNothingLeavesEverythingPossible) {
    const Share share = share_of(0, 0);
    EXPECT_TRUE(std::isnan(share.value));
    EXPECT_EQ(share.interval.low, 0.0);
    EXPECT_EQ(share.interval.high, 1.0);
}

TEST(ShareOf, CoversTheTruthAtLeastNinetyFiveTimesInAHundred) {
    constexpr int trials = 4000;
    constexpr int rocks = 60;
    for (const double truth : {0.02, 0.3}) {
        int covered = 0;
        for (int trial = 0; trial < trials; ++trial) {
            config::RandomStream stream = stream_of(static_cast<std::uint64_t>(trial));
            std::uint64_t hits = 0;
            for (int rock = 0; rock < rocks; ++rock) {
                hits += stream.uniform() < truth ? 1U : 0U;
            }
            const Interval found = share_of(hits, rocks).interval;
            covered += found.low <= truth && truth <= found.high ? 1 : 0;
        }
        EXPECT_GE(static_cast<double>(covered) / trials, 0.95 - four_sigma(0.95, trials)) << truth;
    }
}

TEST(ProtectionEffect, FollowsThePairedRatio) {
    // N_0 = 400, N_f = 100, of them 90 on both slopes: b = 310, c = 10.
    const auto effect = protection_effect({.both = 90, .only_forest = 10, .only_bare = 310});
    ASSERT_TRUE(effect);
    EXPECT_DOUBLE_EQ(effect->value, 0.75);
    const double half_width = 1.959963984540054 * std::sqrt(320.0 / (400.0 * 100.0));
    EXPECT_DOUBLE_EQ(effect->interval.low, 1.0 - 0.25 * std::exp(half_width));
    EXPECT_DOUBLE_EQ(effect->interval.high, 1.0 - 0.25 * std::exp(-half_width));
    EXPECT_FALSE(effect->one_sided);
}

TEST(ProtectionEffect, IsNarrowerOnTheSameRocksThanOnOthers) {
    const auto paired = protection_effect({.both = 100, .only_forest = 0, .only_bare = 300});
    const auto unlike = protection_effect({.both = 0, .only_forest = 100, .only_bare = 400});
    EXPECT_LT(paired->interval.width(), unlike->interval.width());
}

TEST(ProtectionEffect, DoesNotExistWithoutDanger) {
    EXPECT_FALSE(protection_effect({0, 0, 0}));
    EXPECT_FALSE(protection_effect({.both = 0, .only_forest = 5, .only_bare = 0}));
}

TEST(ProtectionEffect, BecomesTheRuleOfThreeWhereNothingComesThrough) {
    const auto effect = protection_effect({.both = 0, .only_forest = 0, .only_bare = 3000});
    ASSERT_TRUE(effect);
    EXPECT_EQ(effect->value, 1.0);
    EXPECT_EQ(effect->interval.high, 1.0);
    EXPECT_TRUE(effect->one_sided);
    EXPECT_NEAR(effect->interval.low, 1.0 - 3.0 / 3000.0, 1e-5);
}

TEST(ProtectionEffect, StaysUnsureWhereNoRockChangedItsFate) {
    const auto effect = protection_effect({.both = 50, .only_forest = 0, .only_bare = 0});
    ASSERT_TRUE(effect);
    EXPECT_EQ(effect->value, 0.0);
    EXPECT_NEAR(effect->interval.high, 1.0 - std::pow(0.025, 1.0 / 50.0), 1e-12);
    EXPECT_EQ(effect->interval.low, -effect->interval.high);
}

TEST(ProtectionEffect, IsCoveredByItsIntervalNinetyFiveTimesInAHundred) {
    constexpr int trials = 3000;
    constexpr int rocks = 1500;
    constexpr double reach_bare = 0.20;
    constexpr double come_through = 0.30;
    constexpr double deflected_to = 0.01;  // rocks that only trees bring to the target
    constexpr double truth =
        1.0 - (reach_bare * come_through + (1.0 - reach_bare) * deflected_to) / reach_bare;
    int covered = 0;
    for (int trial = 0; trial < trials; ++trial) {
        config::RandomStream stream = stream_of(static_cast<std::uint64_t>(trial));
        PairedCounts counts;
        for (int rock = 0; rock < rocks; ++rock) {
            const bool bare = stream.uniform() < reach_bare;
            const bool forest = stream.uniform() < (bare ? come_through : deflected_to);
            counts.both += bare && forest ? 1U : 0U;
            counts.only_bare += bare && !forest ? 1U : 0U;
            counts.only_forest += !bare && forest ? 1U : 0U;
        }
        const auto effect = protection_effect(counts);
        covered += effect->interval.low <= truth && truth <= effect->interval.high ? 1 : 0;
    }
    // One per cent for what the delta method leaves out at some hundred arrivals.
    EXPECT_NEAR(static_cast<double>(covered) / trials, 0.95, four_sigma(0.95, trials) + 0.01);
}

TEST(QuantileRanks, NeedSeventyTwoValuesToBoundTheNinetyFifthPercentileFromAbove) {
    EXPECT_EQ(quantile_ranks(71, 0.95).high, 72U);  // one past the last: none
    EXPECT_EQ(quantile_ranks(72, 0.95).high, 72U);
}

TEST(QuantileRanks, AreTheTightestThatKeepEachTailBelowTwoAndAHalfPercent) {
    for (const int count : {5, 40, 72, 200}) {
        for (const double share : {0.5, 0.95}) {
            std::vector<double> below{0.0};  // below[k] = P(B < k)
            double term = std::pow(1.0 - share, count);
            for (int k = 0; k <= count; ++k) {
                below.push_back(below.back() + term);
                term *= (count - k) / (k + 1.0) * share / (1.0 - share);
            }
            const Ranks ranks = quantile_ranks(static_cast<std::uint64_t>(count), share);
            EXPECT_LE(below[ranks.low], 0.025) << count;
            EXPECT_GT(below[ranks.low + 1], 0.025) << count;
            EXPECT_TRUE(ranks.high > static_cast<std::uint64_t>(count) || 1.0 - below[ranks.high] <= 0.025)
                << count;
            EXPECT_GT(1.0 - below[ranks.high - 1], 0.025) << count;
        }
    }
}

std::vector<std::uint64_t> counted(const std::vector<double>& energies_j) {
    std::vector<std::uint64_t> counts(rockfall::fine_energy_bins.count());
    for (const double energy_j : energies_j) {
        ++counts[rockfall::fine_energy_bins.bin_of(static_cast<float>(energy_j))];
    }
    return counts;
}

TEST(QuantileEstimate, LiesWithinOnePercentOfTheSampleQuantile) {
    std::vector<double> energies_j;
    for (int i = 1; i <= 1000; ++i) {
        energies_j.push_back(500.0 * i);
    }
    const auto estimate = quantile_estimate(rockfall::fine_energy_bins, counted(energies_j), 0.95, 500000.0);
    EXPECT_NEAR(estimate.value, 475000.0, 0.01 * 475000.0);
    EXPECT_LT(estimate.interval.low, 475000.0);
    EXPECT_GT(estimate.interval.high, 475000.0);
}

TEST(QuantileEstimate, NeverExceedsTheLargestValue) {
    const auto estimate = quantile_estimate(rockfall::fine_energy_bins, counted({100000.0}), 0.95, 100000.0);
    EXPECT_LE(estimate.value, 100000.0);
    EXPECT_TRUE(std::isnan(estimate.interval.low));
    EXPECT_TRUE(std::isinf(estimate.interval.high));
}

TEST(QuantileEstimate, OfNothingIsNothing) {
    EXPECT_TRUE(std::isnan(quantile_estimate(rockfall::fine_energy_bins, counted({}), 0.95, 0.0).value));
}

TEST(QuantileEstimate, CoversTheTrueQuantileAtLeastNinetyFiveTimesInAHundred) {
    // Exponential energies: the 95th percentile of mean 50 kJ is 50 ln 20.
    constexpr int trials = 3000;
    constexpr int rocks = 200;
    const double truth_j = 50000.0 * std::log(20.0);
    int covered = 0;
    for (int trial = 0; trial < trials; ++trial) {
        config::RandomStream stream = stream_of(static_cast<std::uint64_t>(trial));
        std::vector<double> energies_j;
        for (int rock = 0; rock < rocks; ++rock) {
            energies_j.push_back(-50000.0 * std::log(1.0 - stream.uniform()));
        }
        const double largest_j = *std::max_element(energies_j.begin(), energies_j.end());
        const Interval found =
            quantile_estimate(rockfall::fine_energy_bins, counted(energies_j), 0.95, largest_j).interval;
        covered += found.low <= truth_j && truth_j <= found.high ? 1 : 0;
    }
    EXPECT_GE(static_cast<double>(covered) / trials, 0.95 - four_sigma(0.95, trials));
}

TEST(RocksForWidth, QuadruplesForHalfTheWidth) {
    EXPECT_EQ(rocks_for_width(1000, 0.2, 0.1), 4000U);
    EXPECT_EQ(rocks_for_half(1000), 4000U);
}

TEST(RiskReduction, JoinsFrequencyAndIntensity) {
    const auto reduction = risk_reduction({.both = 50, .only_forest = 0, .only_bare = 50}, 30.0, 120.0);
    ASSERT_TRUE(reduction);
    EXPECT_DOUBLE_EQ(reduction->bari_percent, 50.0);
    EXPECT_DOUBLE_EQ(reduction->miri_percent, 75.0);
    EXPECT_DOUBLE_EQ(reduction->orpi_percent, 87.5);
    EXPECT_DOUBLE_EQ(
        risk_reduction({.both = 0, .only_forest = 0, .only_bare = 9}, std::nan(""), 120.0)->orpi_percent,
        100.0);
}

TEST(RiskReduction, TellsNothingOfIntensityFromPercentilesThatAreNotKnown) {
    for (const PairedCounts& counts : {PairedCounts{.both = 5, .only_forest = 0, .only_bare = 5},
                                       PairedCounts{.both = 0, .only_forest = 0, .only_bare = 5}}) {
        const auto reduction = risk_reduction(counts, std::nan(""), std::nan(""));
        ASSERT_TRUE(reduction);
        EXPECT_DOUBLE_EQ(reduction->bari_percent, counts.both == 0 ? 100.0 : 50.0);
        EXPECT_TRUE(std::isnan(reduction->miri_percent));
        EXPECT_TRUE(std::isnan(reduction->orpi_percent));
    }
}

TEST(PercentileIsKnown, FromTheRockOnThatLiesAboveIt) {
    EXPECT_TRUE(percentile_is_known(10, 90) && percentile_is_known(20, 95) && percentile_is_known(100, 99));
    EXPECT_FALSE(percentile_is_known(9, 90) || percentile_is_known(19, 95) || percentile_is_known(99, 99));
    EXPECT_FALSE(percentile_is_known(0, 50));
}

}  // namespace
}  // namespace coupling::indicators_test
