#include "coupling/results/figures/effect_words.hpp"

#include <gtest/gtest.h>

namespace coupling::effect_words_test {
namespace {

/// Arrivals of 1000 rocks: how many arrive, how many with more than 300 kJ, the 95 % energy with its interval
/// and the mean.
ArrivalFigures arrivals(std::uint64_t reached, std::uint64_t above_300, Distribution energy_kj) {
    ArrivalFigures figures;
    figures.share = share_of(reached, 1000);
    figures.energy_kj = energy_kj;
    figures.above[0] = figures.above[1] = share_of(reached, 1000);
    figures.above[2] = share_of(above_300, 1000);
    figures.above[3] = share_of(0, 1000);
    return figures;
}

Distribution energy(double mean, double p95, double low, double high) {
    Distribution d;
    d.mean = mean;
    d.p95 = p95;
    d.p95_interval = {low, high};
    return d;
}

TargetFigures target(const ArrivalFigures& forest, const ArrivalFigures& bare) {
    TargetFigures figures;
    figures.by_cover = {forest, bare};
    figures.paired = {forest.share.part, 0, bare.share.part - forest.share.part};
    figures.protection = protection_effect(figures.paired);
    figures.reduction = risk_reduction(figures.paired, forest.energy_kj.p95, bare.energy_kj.p95);
    return figures;
}

TEST(RatePer1000, HasTwoDigitsBelowOne) {
    EXPECT_EQ(rate_per_1000(0.1564), "156");
    EXPECT_EQ(rate_per_1000(0.09996), "100");
    EXPECT_EQ(rate_per_1000(0.02437), "24.4");
    EXPECT_EQ(rate_per_1000(0.000999), "1.0");
    EXPECT_EQ(rate_per_1000(0.000598), "0.60");
    EXPECT_EQ(rate_per_1000(0.0000767), "0.077");
    EXPECT_EQ(rate_per_1000(0.0), "0");
    EXPECT_EQ(rate_per_1000(NAN), "–");
}

TEST(ReductionInWords, ExplainsA95PercentEnergyThatTheForestRaises) {
    const std::string text =
        reduction_in_words(target(arrivals(100, 30, energy(150.0, 492.0, 480.0, 505.0)),
                                  arrivals(300, 50, energy(120.0, 400.0, 390.0, 410.0))));
    EXPECT_EQ(
        text,
        "66.7\u00a0% fewer rocks (BARI). The 95\u00a0% energy of those that still arrive is 23.0\u00a0% "
        "higher (MIRI \u221223.0\u00a0%), because the forest stops small and slow rocks more often than "
        "large and fast ones. Rocks above 300\u00a0kJ per 1000 released fall from 50.0 to 30.0. "
        "Combined (ORPI): 59.0\u00a0%.");
}

TEST(ReductionInWords, SaysWhenARiseLiesWithinTheUncertainty) {
    const std::string text =
        reduction_in_words(target(arrivals(100, 30, energy(150.0, 410.0, 380.0, 440.0)),
                                  arrivals(300, 50, energy(120.0, 400.0, 390.0, 410.0))));
    EXPECT_NE(text.find("2.5\u00a0% higher (MIRI \u22122.5\u00a0%), within the uncertainty"),
              std::string::npos)
        << text;
    EXPECT_EQ(text.find("because"), std::string::npos) << "chance may be the cause: " << text;
}

TEST(ReductionInWords, ExplainsAMeanThatRisesWhereThe95PercentEnergyFalls) {
    const std::string text =
        reduction_in_words(target(arrivals(100, 30, energy(150.0, 380.0, 370.0, 390.0)),
                                  arrivals(300, 50, energy(120.0, 400.0, 390.0, 410.0))));
    EXPECT_NE(
        text.find("is 5.0\u00a0% lower (MIRI 5.0\u00a0%). The mean energy of those that still arrive is "
                  "25.0\u00a0% higher, because"),
        std::string::npos)
        << text;
}

TEST(ReductionInWords, SaysNothingOfARiseWhereThereIsNone) {
    const std::string text =
        reduction_in_words(target(arrivals(100, 10, energy(90.0, 300.0, 290.0, 310.0)),
                                  arrivals(300, 50, energy(120.0, 400.0, 390.0, 410.0))));
    EXPECT_EQ(text.find("higher"), std::string::npos) << text;
    EXPECT_EQ(text.find("because"), std::string::npos) << text;
}

TEST(ReductionInWords, OfAForestThatStopsAllRocks) {
    const std::string text = reduction_in_words(
        target(arrivals(0, 0, Distribution{}), arrivals(300, 50, energy(120.0, 400.0, 390.0, 410.0))));
    EXPECT_EQ(text,
              "100.0\u00a0% fewer rocks (BARI). No rock gets through (MIRI 100.0\u00a0%). Combined "
              "(ORPI): 100.0\u00a0%.");
}

TEST(EnergyRise, IsNoneFromAHandfulOfRocks) {
    EXPECT_FALSE(energy_rise(arrivals(4, 1, energy(150.0, 492.0, 480.0, 505.0)),
                             arrivals(300, 50, energy(120.0, 400.0, 390.0, 410.0))));
}

TEST(ChangeOfStrongRocks, TakesTheLargestEnergyThatSomeRocksExceed) {
    const ArrivalFigures bare = arrivals(300, 4, energy(120.0, 400.0, 390.0, 410.0));
    const ArrivalFigures forest = arrivals(100, 1, energy(120.0, 400.0, 390.0, 410.0));
    EXPECT_EQ(change_of_strong_rocks(forest, bare),
              "Rocks above 100\u00a0kJ per 1000 released fall from 300 to 100.");
}

}  // namespace
}  // namespace coupling::effect_words_test
