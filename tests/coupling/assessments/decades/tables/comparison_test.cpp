#include "coupling/assessments/decades/tables/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace coupling::decades::comparison_test {
namespace {

/// Two regimes, three replicates; the second regime lacks year 1 in its last replicate.
Series some_series() {
    Series series;
    series.quantity = "protection_percent";
    series.values = {{{{0, 80.0}, {1, 70.0}}, {{0, 82.0}, {1, 72.0}}, {{0, 84.0}, {1, 80.0}}},
                     {{{0, 81.0}, {1, 75.0}}, {{0, 85.0}, {1, 73.0}}, {{0, 89.0}}}};
    return series;
}

TEST(Comparison, TakesMeansOverTheReplicatesThatKnowAFigure) {
    const Series series = some_series();
    EXPECT_EQ(years_of(series), (std::vector<std::int32_t>{0, 1}));
    EXPECT_DOUBLE_EQ(over_replicates(series, 0, 1)->band.mean, 74.0);
    EXPECT_EQ(over_replicates(series, 1, 1)->replicates, 2U);
    EXPECT_DOUBLE_EQ(over_replicates(series, 1, 1)->band.mean, 74.0);
    EXPECT_FALSE(over_replicates(series, 1, 2));
}

/// A replicate in which two rocks would arrive does not count as much as one with 98.
TEST(Comparison, TakesRatiosOverTheRocksOfAllReplicates) {
    Series series;
    series.quantity = "protection_percent";
    series.values = {{{{1, 100.0}}, {{1, 50.0}}, {{1, 60.0}}}, {{{1, 50.0}}, {{1, 50.0}}, {{1, 80.0}}}};
    series.weights = {{{{1, 2.0}}, {{1, 98.0}}, {{1, 100.0}}}, {{{1, 2.0}}, {{1, 98.0}}, {{1, 100.0}}}};
    EXPECT_NEAR(over_replicates(series, 0, 1)->band.mean, (2.0 + 49.0 + 60.0) / 2.0, 1e-9);
    EXPECT_NEAR(over_replicates(series, 1, 1)->band.mean, (1.0 + 49.0 + 80.0) / 2.0, 1e-9);
    EXPECT_NEAR(difference(series, 1, 0, 1)->mean, 65.0 - 55.5, 1e-9);
    EXPECT_EQ(over_replicates(series, 0, 1)->band.most, 100.0) << "of the replicates themselves";
    const Series parts = as_parts(series);
    EXPECT_NEAR(over_replicates(parts, 0, 1)->band.mean, 55.5, 1e-9);
    EXPECT_NEAR(difference(parts, 1, 0, 1)->low, difference(series, 1, 0, 1)->low, 1e-9);
    series.weights = {{{{1, 7.0}}, {{1, 7.0}}, {{1, 7.0}}}, {{{1, 7.0}}, {{1, 7.0}}, {{1, 7.0}}}};
    const Band equal = over_replicates(series, 0, 1)->band;
    series.weights.clear();
    EXPECT_NEAR(over_replicates(series, 0, 1)->band.mean, equal.mean, 1e-9);
    EXPECT_NEAR(over_replicates(series, 0, 1)->band.low, equal.low, 1e-9);
}

TEST(Comparison, PairsRegimesByReplicate) {
    // Differences 1, 3 and 5: mean 3, standard error 2 / sqrt(3), t = 4.302653 with two degrees of freedom.
    const auto found = difference(some_series(), 1, 0, 0);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->pairs, 3U);
    EXPECT_DOUBLE_EQ(found->mean, 3.0);
    EXPECT_NEAR(found->low, 3.0 - 4.302653 * 2.0 / std::sqrt(3.0), 1e-5);
    EXPECT_NEAR(found->high, 3.0 + 4.302653 * 2.0 / std::sqrt(3.0), 1e-5);
    EXPECT_EQ(difference(some_series(), 1, 0, 1)->pairs, 2U);
}

TEST(Comparison, CutsIntervalsAtWhatAFigureCanBe) {
    Series series = some_series();
    EXPECT_EQ(bounds_of(series).high, 100.0);
    EXPECT_TRUE(std::isinf(bounds_of(series).low)) << "a forest may let more rocks through than bare ground";
    series.quantity = "reached_percent";
    EXPECT_EQ(bounds_of(series).low, 0.0);
    series.quantity = "removed_m3pha";
    EXPECT_EQ(bounds_of(series).low, 0.0);
    EXPECT_TRUE(std::isinf(bounds_of(series).high));
    series.quantity = "contribution_margin_eur_pha";
    EXPECT_TRUE(std::isinf(bounds_of(series).low)) << "work may cost more than it brings";
}

TEST(Comparison, KnowsNoIntervalOfASinglePair) {
    Series series = some_series();
    for (auto& replicates : series.values) {
        replicates.resize(1);
    }
    const auto found = difference(series, 1, 0, 0);
    ASSERT_TRUE(found);
    EXPECT_DOUBLE_EQ(found->mean, 1.0);
    EXPECT_TRUE(std::isnan(found->low));
    EXPECT_TRUE(std::isnan(found->high));
}

TEST(Comparison, KnowsNoIntervalOfEqualDifferences) {
    Series series = some_series();
    series.values[1] = {{{0, 81.0}}, {{0, 83.0}}, {{0, 85.0}}};
    const auto found = difference(series, 1, 0, 0);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->pairs, 3U);
    EXPECT_DOUBLE_EQ(found->mean, 1.0);
    EXPECT_TRUE(std::isnan(found->low)) << "three equal differences are not certainty";
}

TEST(Comparison, FindsTheWorstYearOnTheBadSide) {
    Series series = some_series();
    EXPECT_EQ(worst_year(series, 0)->year, 1);
    EXPECT_DOUBLE_EQ(worst_year(series, 0)->value.band.mean, 74.0);
    series.low_is_bad = false;
    EXPECT_EQ(worst_year(series, 0)->year, 0);
    EXPECT_DOUBLE_EQ(worst_year(series, 0)->value.band.mean, 82.0);
}

}  // namespace
}  // namespace coupling::decades::comparison_test
