#include "coupling/results/figures/figures.hpp"

#include <gtest/gtest.h>

#include "tests/coupling/results/small_run.hpp"

namespace coupling::figures_test {
namespace {

using small_runs::SmallRun;

TEST(FiguresOf, CountsPairsAtATarget) {
    SmallRun run;
    run.fall(400);
    const Figures figures = figures_of(run.results());
    const TargetFigures& road = figures.targets[0];
    EXPECT_EQ(road.at(Cover::bare).share.part, 40U);
    EXPECT_EQ(road.at(Cover::forest).share.part, 10U);
    EXPECT_EQ(road.paired.both, 10U);
    EXPECT_EQ(road.paired.only_bare, 30U);
    EXPECT_EQ(road.paired.only_forest, 0U);
    ASSERT_TRUE(road.protection);
    EXPECT_DOUBLE_EQ(road.protection->value, 0.75);
}

TEST(FiguresOf, CountsRocksAboveEnergiesExactly) {
    SmallRun run;
    run.fall(400);
    const ArrivalFigures& bare = figures_of(run.results()).targets[0].at(Cover::bare);
    for (std::size_t i = 0; i < bare.above.size(); ++i) {
        std::uint64_t above = 0;
        for (int rock = 0; rock < 400; rock += 10) {
            const float energy_j = 20000.0F + 2000.0F * static_cast<float>(rock % 89);
            above += energy_j >= rockfall::counted_energies_j[i] ? 1U : 0U;
        }
        EXPECT_EQ(bare.above[i].part, above) << i;
        EXPECT_EQ(bare.above[i].whole, 400U) << "of all rocks released, not of those that arrive";
    }
    EXPECT_GT(bare.above[0].part, bare.above[1].part);
}

TEST(FiguresOf, TakesMeansFromSumsAndPercentilesFromBins) {
    SmallRun run;
    run.fall(400);
    const Distribution energy = figures_of(run.results()).targets[0].at(Cover::bare).energy_kj;
    double sum_kj = 0.0;
    double largest_kj = 0.0;
    for (int rock = 0; rock < 400; rock += 10) {
        const double energy_kj = 20.0 + 2.0 * (rock % 89);
        sum_kj += energy_kj;
        largest_kj = std::max(largest_kj, energy_kj);
    }
    EXPECT_NEAR(energy.mean, sum_kj / 40.0, 1e-9);
    EXPECT_NEAR(energy.max, largest_kj, 1e-3);
    EXPECT_LE(energy.p50, energy.p90);
    EXPECT_LE(energy.p90, energy.p95);
    EXPECT_TRUE(std::isinf(energy.p95_interval.high)) << "40 arrivals are too few";
}

TEST(FiguresOf, PercentilesRiseToTheLargestValue) {
    SmallRun run;
    run.fall(1000);
    const Distribution energy = figures_of(run.results()).targets[0].at(Cover::bare).energy_kj;
    EXPECT_LE(energy.p95, energy.p98);
    EXPECT_LE(energy.p98, energy.p99);
    EXPECT_LE(energy.p99, energy.max);
}

TEST(FiguresOf, APercentileThatNoWholeRockLiesAboveIsNotKnown) {
    SmallRun run;
    run.fall(400);
    const TargetFigures road = figures_of(run.results()).targets[0];
    const Distribution& bare = road.at(Cover::bare).energy_kj;
    EXPECT_FALSE(std::isnan(bare.p95)) << "two of 40 lie above";
    EXPECT_TRUE(std::isnan(bare.p98));
    EXPECT_TRUE(std::isnan(bare.p99));
    const Distribution& forest = road.at(Cover::forest).energy_kj;
    EXPECT_FALSE(std::isnan(forest.p90)) << "one of 10 lies above";
    EXPECT_TRUE(std::isnan(forest.p95));
    EXPECT_FALSE(std::isnan(forest.max));
    ASSERT_TRUE(road.reduction);
    EXPECT_DOUBLE_EQ(road.reduction->bari_percent, 75.0);
    EXPECT_TRUE(std::isnan(road.reduction->miri_percent));
    EXPECT_TRUE(std::isnan(road.reduction->orpi_percent));
}

TEST(FiguresOf, LeavesATargetWithoutArrivalsUnknown) {
    SmallRun run;
    run.fall(400);
    const TargetFigures house = figures_of(run.results()).targets[1];
    EXPECT_EQ(house.at(Cover::bare).share.part, 0U);
    EXPECT_TRUE(std::isnan(house.at(Cover::bare).energy_kj.mean));
    EXPECT_FALSE(house.protection);
}

TEST(FiguresOf, SharesStopReasonsAmongAllRocks) {
    SmallRun run;
    run.fall(400);
    const SlopeFigures forest = figures_of(run.results()).at(Cover::forest);
    double sum = 0.0;
    for (const Share& share : forest.by_reason) {
        sum += share.value;
    }
    EXPECT_DOUBLE_EQ(sum, 1.0);
    EXPECT_EQ(forest.by_reason[static_cast<std::size_t>(rockfall::StopReason::tree)].part, 390U);
    EXPECT_DOUBLE_EQ(forest.tree_hits_per_rock, 1.5);
    EXPECT_EQ(forest.hit_a_tree.part, 300U);
}

TEST(FiguresOf, PutsRunOutPercentilesInsideTheirBins) {
    SmallRun run;
    run.fall(400);
    const Distribution run_out = figures_of(run.results()).at(Cover::bare).run_out_m;
    EXPECT_NEAR(run_out.mean, 0.9 * 35.0 + 0.1 * 70.0, 1e-9);
    EXPECT_GE(run_out.p50, 30.0);  // nine of ten rocks run out 35 m
    EXPECT_LE(run_out.p50, 40.0);
    EXPECT_LE(run_out.p99, 70.0);
    EXPECT_DOUBLE_EQ(run_out.max, 70.0);
}

TEST(FiguresOf, AnEmptyRunHasNoFiguresAndDoesNotFail) {
    const SmallRun run;
    const Figures figures = figures_of(run.results());
    EXPECT_TRUE(std::isnan(figures.at(Cover::bare).run_out_m.mean));
    EXPECT_TRUE(std::isnan(figures.targets[0].at(Cover::bare).share.value));
}

}  // namespace
}  // namespace coupling::figures_test
