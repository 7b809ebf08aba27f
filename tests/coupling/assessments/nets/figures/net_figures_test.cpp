#include "coupling/assessments/nets/figures/net_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace coupling::net_figures_test {
namespace {

NetRow row(std::uint64_t rock, float energy_kj, float height_m, rockfall::NetOutcome outcome,
           bool first = true) {
    NetRow made;
    made.rock = rock;
    made.crossing.energy_j = 1000.0F * energy_kj;
    made.crossing.height_m = height_m;
    made.crossing.outcome = outcome;
    made.crossing.first = first;
    return made;
}

TEST(QuantileOf, IsTheSmallestValueThatTheShareDoesNotExceed) {
    std::vector<double> values;
    for (int i = 1; i <= 100; ++i) {
        values.push_back(i);
    }
    const QuantileEstimate p95 = quantile_of(values, 0.95);
    EXPECT_EQ(p95.value, 95.0);
    EXPECT_LT(p95.interval.low, 95.0);
    EXPECT_GT(p95.interval.high, 95.0);
    EXPECT_TRUE(std::isinf(quantile_of(std::vector{1.0, 2.0}, 0.95).interval.high));
}

TEST(NetFigures, CountEachRockOnceAsItFirstCrosses) {
    using rockfall::NetOutcome;
    const std::vector<NetRecord> nets(1);
    const std::vector<NetRow> rows{
        row(1, 10.0F, 0.5F, NetOutcome::held), row(2, 20.0F, 4.0F, NetOutcome::over),
        row(2, 15.0F, 1.0F, NetOutcome::held, false), row(3, 900.0F, 1.0F, NetOutcome::broke)};
    const auto figures = net_figures(nets, rows, rockfall::Cover::bare, 10, 0.95);
    ASSERT_EQ(figures.size(), 1U);
    EXPECT_EQ(figures[0].reached.part, 3U);
    EXPECT_EQ(figures[0].reached.whole, 10U);
    std::uint64_t sum = 0;
    for (const Share& share : figures[0].outcome) {
        sum += share.part;
    }
    EXPECT_EQ(sum, 3U);
    EXPECT_DOUBLE_EQ(figures[0].energy_kj.mean, 310.0);
    EXPECT_EQ(net_figures(nets, rows, rockfall::Cover::forest, 10, 0.95)[0].reached.part, 0U);
}

TEST(NetFigures, LeaveOutPercentilesAboveWhichFewerThanOneRockLies) {
    const std::vector<NetRecord> nets(1);
    std::vector<NetRow> rows;
    const auto figures = [&] { return net_figures(nets, rows, rockfall::Cover::bare, 1000, 0.95)[0]; };
    while (rows.size() < 19) {
        rows.push_back(row(rows.size(), 10.0F, 0.5F, rockfall::NetOutcome::held));
    }
    EXPECT_TRUE(std::isnan(figures().energy_kj.p95.value));
    EXPECT_TRUE(figures().needs.empty());
    EXPECT_EQ(figures().energy_kj.p90, 10.0);
    rows.push_back(row(20, 10.0F, 0.5F, rockfall::NetOutcome::held));
    EXPECT_EQ(figures().energy_kj.p95.value, 10.0);
    EXPECT_EQ(figures().height_m.p95.value, 0.5);
    EXPECT_TRUE(std::isnan(figures().energy_kj.p99.value));
    EXPECT_FALSE(figures().needs.empty());
    rows.resize(9);
    EXPECT_TRUE(std::isnan(figures().energy_kj.p90));
}

TEST(RocksToTell, AreOneThatMayPass) {
    EXPECT_EQ(rocks_to_tell(0.5), 2U);
    EXPECT_EQ(rocks_to_tell(0.9), 10U);
    EXPECT_EQ(rocks_to_tell(0.95), 20U);
    EXPECT_EQ(rocks_to_tell(0.97), 34U);
    EXPECT_EQ(rocks_to_tell(0.99), 100U);
    EXPECT_EQ(rocks_to_tell(0.9999), 10000U);
}

TEST(FindNeeds, TakesEnergyAndHeightAsOneRequirement) {
    // 100 rocks: 3 of more than 500 kJ (low), 4 others higher than 3 m. 95 % cannot be held at 3 m.
    std::vector<double> energies_kj(100, 200.0);
    std::vector<double> heights_m(100, 2.0);
    for (int i = 0; i < 3; ++i) {
        energies_kj[static_cast<std::size_t>(i)] = 800.0;
    }
    for (int i = 3; i < 7; ++i) {
        heights_m[static_cast<std::size_t>(i)] = 3.0 + 0.51 * (i - 2);
    }
    NetFigures figures;
    find_needs(figures, energies_kj, heights_m, 0.95);
    // (1 + 0.95) / 2 of the rocks have up to 800 kJ: class 3 (1000 kJ) leaves all the rest to the height.
    const NetNeed& need = figures.needs[figures.recommended];
    EXPECT_EQ(need.energy_class, "3");
    EXPECT_EQ(figures.energy_needed_kj, 800.0);
    EXPECT_DOUBLE_EQ(need.height_m.value(), 2.0 + 0.0);
    EXPECT_EQ(need.held.part, 96U);
    // Class 2 (500 kJ) holds no more than 97; 95 of them need 4.1 m: 93 low ones and two of the high ones.
    EXPECT_EQ(figures.needs[2].energy_class, "2");
    EXPECT_DOUBLE_EQ(figures.needs[2].height_m.value(), 4.1);
    EXPECT_EQ(figures.needs[2].held.part, 95U);
    // Class 0 (100 kJ) holds nothing, at no height.
    EXPECT_FALSE(figures.needs[0].height_m.has_value());
    EXPECT_EQ(figures.needs[0].held.part, 0U);
}

}  // namespace
}  // namespace coupling::net_figures_test
