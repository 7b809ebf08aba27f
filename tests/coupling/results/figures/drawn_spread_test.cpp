#include "coupling/results/figures/drawn_spread.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "coupling/results/figures/drawn_words.hpp"
#include "coupling/results/report/interval_rows.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::drawn_spread_test {
namespace {

constexpr std::size_t strata = 20;

/// Half of the strata have one mean, half another one; each is known up to a variance.
std::vector<StratumFigure> two_means(double low, double high, double chance) {
    std::vector<StratumFigure> figures;
    for (std::size_t k = 0; k < strata; ++k) {
        figures.push_back({k % 2 == 0 ? low : high, chance, k});
    }
    return figures;
}

/// The energy of rocks that move is above 0: where the interval reaches 0, its lower end is not known.
TEST(DrawnSpread, GivesNoEnergyALowerEndOfNothing) {
    const DrawnSpread spread{strata};
    const std::vector<StratumFigure> wide = two_means(1.0, 21.0, 1.0);
    const auto energy = spread.figure(11.0, {9.0, 13.0}, above_nothing, wide);
    ASSERT_TRUE(energy);
    EXPECT_TRUE(energy->has_spread);
    EXPECT_GT(energy->of_all.low, 0.0);
    const auto wider = spread.figure(8.0, {6.0, 10.0}, above_nothing, two_means(-5.0, 21.0, 1.0));
    ASSERT_TRUE(wider);
    EXPECT_TRUE(std::isnan(wider->of_all.low));
    EXPECT_EQ(wider->of_rocks.low, 6.0);
    EXPECT_EQ(report::interval_in_words(wider->of_all, report::three_digits).find("at most "), 0U);
    EXPECT_NE(spread_in_words(*wider).find("lower end is not known"), std::string::npos);
    // By chance of few rocks alone, too.
    const auto few = spread.figure(1.0, {-0.5, 2.5}, above_nothing, two_means(1.0, 1.0, 1.0));
    ASSERT_TRUE(few);
    EXPECT_TRUE(std::isnan(few->of_rocks.low));
    // A height may be 0, and that is its least.
    const auto height = spread.figure(8.0, {6.0, 10.0}, {}, two_means(-5.0, 21.0, 1.0));
    ASSERT_TRUE(height);
    EXPECT_EQ(height->of_all.low, 0.0);
}

TEST(DrawnSpread, SaysWhereDrawsShowNoSpread) {
    const DrawnSpread spread{strata};
    const auto none = spread.figure(10.0, {8.0, 13.0}, above_nothing, two_means(10.0, 10.0, 4.0));
    ASSERT_TRUE(none);
    EXPECT_FALSE(none->has_spread);
    EXPECT_LT(none->of_all.low, none->of_rocks.low);
    EXPECT_GT(none->of_all.high, none->of_rocks.high);
    for (const double share : none->shares) {
        EXPECT_EQ(share, 0.0);
    }
    EXPECT_EQ(spread_in_words(*none), "draws show no spread; the interval holds one that chance could hide");
    const auto some = spread.figure(10.0, {8.0, 13.0}, above_nothing, two_means(6.0, 14.0, 0.1));
    ASSERT_TRUE(some);
    EXPECT_TRUE(some->has_spread);
    EXPECT_EQ(spread_in_words(*some), "");
}

/// Strata in which no rock comes are those of draws that stop rocks early: without them a figure has the
/// spread of the others.
TEST(DrawnSpread, IsNotGivenByAFewStrataForAll) {
    const auto means_with = [](std::size_t strata_with_rocks) {
        return means_of_strata(strata, [&](std::size_t k) {
            return k < strata_with_rocks ? StratumSample{10.0, 5.0, 20.0} : StratumSample{};
        });
    };
    EXPECT_EQ(means_with(15).size(), 15U);  // three quarters of 20
    EXPECT_TRUE(means_with(14).empty());
    EXPECT_TRUE(are_most(48, 64));
    EXPECT_FALSE(are_most(47, 64));
}

RC_GTEST_PROP(DrawnSpread, NeverEndsAnEnergyAtNothing, ()) {
    const DrawnSpread spread{strata};
    const double mean = *rc::gen::inRange(1, 100);
    const double half = *rc::gen::inRange(0, 150);
    const double apart = *rc::gen::inRange(0, 200);
    const auto figure =
        spread.figure(mean, {mean - half, mean + half}, above_nothing,
                      two_means(mean - apart, mean + apart, 1.0 + 0.1 * *rc::gen::inRange(0, 50)));
    RC_ASSERT(figure.has_value());
    for (const Interval& interval : {figure->of_rocks, figure->of_all}) {
        RC_ASSERT(std::isnan(interval.low) || interval.low > 0.0);
    }
    RC_ASSERT(std::isnan(figure->of_rocks.low) == (mean - half <= 0.0));
    RC_ASSERT(std::isnan(figure->of_all.low) || figure->of_all.low <= figure->of_rocks.low);
}

}  // namespace
}  // namespace coupling::drawn_spread_test
