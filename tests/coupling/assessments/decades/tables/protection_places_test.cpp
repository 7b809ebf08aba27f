#include "coupling/assessments/decades/tables/protection_places.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace coupling::decades::protection_places_test {
namespace {

TEST(FreedShare, IsThatOfTheRocksThatMetNoTree) {
    EXPECT_DOUBLE_EQ(
        freed_share({.spared = 7, .came = 100, .met = 50, .missed = 40, .missed_arrived = 10}).value(), 0.25);
}

TEST(FreedShare, IsUnknownWhereTooFewMetNone) {
    EXPECT_FALSE(freed_share({.came = 100, .met = 81, .missed = 19, .missed_arrived = 19}));
    EXPECT_TRUE(freed_share({.came = 100, .met = 80, .missed = 20, .missed_arrived = 19}));
    EXPECT_FALSE(freed_share({}));
}

/// A forest of even bands: in each a share of the rocks that come meets a tree, and all that do stop there.
TargetBands even_forest(std::size_t bands, double met_share, std::uint32_t rocks) {
    TargetBands target;
    target.bands.resize(bands);
    double coming = rocks;
    const double through = rocks * std::pow(1.0 - met_share, static_cast<double>(bands));
    for (std::size_t band = bands; band-- > 0;) {
        exchange::PlaceCounts& counts = target.bands[band];
        counts.came = static_cast<std::uint32_t>(std::lround(coming));
        counts.met = static_cast<std::uint32_t>(std::lround(coming * met_share));
        counts.spared = static_cast<std::int32_t>(counts.met);
        counts.missed = counts.came - counts.met;
        counts.missed_arrived = static_cast<std::uint32_t>(std::lround(through));
        coming *= 1.0 - met_share;
    }
    target.paired = {static_cast<std::uint64_t>(std::lround(through)), 0,
                     rocks - static_cast<std::uint64_t>(std::lround(through))};
    return target;
}

TEST(LossByACut, IsTheSameInEachBandOfAnEvenForestHoweverManyItStops) {
    // A filter that halves what comes, three times: without any one of them twice as much comes through,
    // though the uppermost stops four times as many as the lowest.
    const TargetBands forest = even_forest(3, 0.5, 80'000);
    for (std::size_t band = 0; band < 3; ++band) {
        EXPECT_NEAR(forest.lost_percent(band, 1), 12.5, 1e-9);
    }
    EXPECT_NEAR(forest.lost_percent(0, 2), 25.0, 1e-9);  // each alone, added up
    EXPECT_EQ(forest.spared_in(0, 3), forest.spared());
    EXPECT_NEAR(forest.spared_percent(0, 1), 100.0 / 7.0, 1e-9);
    EXPECT_NEAR(forest.spared_percent(2, 1), 400.0 / 7.0, 1e-9);
}

TEST(LossByACut, IsNothingWhereNoTreeStands) {
    TargetBands forest = even_forest(3, 0.5, 80'000);
    exchange::PlaceCounts& open = forest.bands[1];
    open.missed += open.met;
    open.met = 0;
    open.spared = 0;
    EXPECT_EQ(forest.lost_percent(1, 1), 0.0);
    EXPECT_EQ(forest.lost_percent(1, 7), forest.lost_percent(2, 1));
}

TEST(LossByACut, IsAGainWhereTreesMakeRocksArrive) {
    TargetBands forest = even_forest(3, 0.5, 80'000);
    forest.bands[0].spared = -100;
    EXPECT_LT(forest.lost_percent(0, 1), 0.0);
}

TEST(LossByACut, IsUnknownWhereEveryRockMeetsATree) {
    EXPECT_TRUE(std::isnan(even_forest(3, 1.0, 1000).lost_percent(2, 1)));
    EXPECT_TRUE(std::isnan(TargetBands{}.spared_percent(0, 1)));
}

TEST(PooledBands, HaveAnIntervalFromThreeReplicatesOn) {
    const std::vector<TargetBands> equal(3, even_forest(3, 0.5, 8000));
    EXPECT_FALSE(PooledBands{equal}.lost_percent(0, 1).has_interval());  // all agree
    std::vector<TargetBands> replicates{even_forest(3, 0.4, 8000), even_forest(3, 0.5, 8000)};
    EXPECT_FALSE(PooledBands{replicates}.lost_percent(0, 1).has_interval());
    replicates.push_back(even_forest(3, 0.6, 8000));
    const PooledFigure lost = PooledBands{replicates}.lost_percent(0, 1);
    EXPECT_TRUE(lost.has_interval());
    EXPECT_LT(lost.low, lost.value);
    EXPECT_LT(lost.value, lost.high);
    EXPECT_EQ(PooledBands{replicates}.pool().spared(),
              replicates[0].spared() + replicates[1].spared() + replicates[2].spared());
}

}  // namespace
}  // namespace coupling::decades::protection_places_test
