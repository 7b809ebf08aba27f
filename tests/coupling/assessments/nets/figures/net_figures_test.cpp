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
    made.crossing.radius_m = 0.25F;
    made.crossing.outcome = outcome;
    made.crossing.first = first;
    return made;
}

TEST(NetFigures, CountEachRockOnceAsItFirstCrosses) {
    using rockfall::NetOutcome;
    const std::vector<NetRecord> nets(1);
    const std::vector<NetRow> rows{
        row(1, 10.0F, 0.5F, NetOutcome::held), row(2, 20.0F, 4.0F, NetOutcome::over),
        row(2, 15.0F, 1.0F, NetOutcome::held, false), row(3, 900.0F, 1.0F, NetOutcome::broke)};
    const auto figures = net_figures(nets, rows, rockfall::Cover::bare, 10, {});
    ASSERT_EQ(figures.size(), 1U);
    EXPECT_EQ(figures[0].reached.part, 3U);
    EXPECT_EQ(figures[0].reached.whole, 10U);
    std::uint64_t sum = 0;
    for (const Share& share : figures[0].outcome) {
        sum += share.part;
    }
    EXPECT_EQ(sum, 3U);
    EXPECT_DOUBLE_EQ(figures[0].energy_kj.mean, 310.0);
    EXPECT_EQ(net_figures(nets, rows, rockfall::Cover::forest, 10, {})[0].reached.part, 0U);
}

TEST(NetFigures, LeaveOutPercentilesAboveWhichFewerThanOneRockLies) {
    const std::vector<NetRecord> nets(1);
    std::vector<NetRow> rows;
    const auto figures = [&] { return net_figures(nets, rows, rockfall::Cover::bare, 1000, {})[0]; };
    while (rows.size() < 19) {
        rows.push_back(row(rows.size(), 10.0F, 0.5F, rockfall::NetOutcome::held));
    }
    EXPECT_TRUE(std::isnan(figures().energy_kj.p95.value));
    EXPECT_FALSE(figures().design);
    EXPECT_TRUE(figures().classes.empty());
    EXPECT_EQ(figures().energy_kj.p90, 10.0);
    rows.push_back(row(20, 10.0F, 0.5F, rockfall::NetOutcome::held));
    EXPECT_EQ(figures().energy_kj.p95.value, 10.0);
    EXPECT_EQ(figures().height_m.p95.value, 0.75);  // the upper edge
    EXPECT_TRUE(std::isnan(figures().energy_kj.p99.value));
    EXPECT_EQ(figures().design->percentile_height_m, 0.75);
    EXPECT_FALSE(figures().classes.empty());
    rows.resize(9);
    EXPECT_TRUE(std::isnan(figures().energy_kj.p90));
}

}  // namespace
}  // namespace coupling::net_figures_test
