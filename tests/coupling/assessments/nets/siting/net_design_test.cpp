#include "coupling/assessments/nets/siting/net_design.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace coupling::siting::net_design_test {
namespace {

CrossingRock rock(double along_m, double height_m, double energy_kj) {
    return {{{along_m, height_m, energy_kj}}, energy_kj + 10.0};
}

/// Rocks evenly along 20 to 40 m, 1 m high, 80 kJ.
std::vector<CrossingRock> even_rocks(int count) {
    std::vector<CrossingRock> rocks;
    for (int i = 0; i < count; ++i) {
        rocks.push_back(rock(20.0 + 20.0 * i / (count - 1), 1.0, 80.0));
    }
    return rocks;
}

TEST(DesignNet, IsTheWeakestClassLowestAndShortestThatHolds) {
    std::vector<CrossingRock> rocks = even_rocks(100);
    const auto net = design_net(rocks, 0.95, 60.0);
    ASSERT_TRUE(net);
    EXPECT_EQ(net->energy_class, "0");  // 100 kJ
    EXPECT_DOUBLE_EQ(net->height_m, 1.0);
    EXPECT_GE(net->from_m, 19.0);
    EXPECT_LE(net->to_m, 40.0);
    EXPECT_GE(left_below(rocks, *net).kept.part, 95U);
}

TEST(DesignNet, LeavesTheFewStrongAndHighRocks) {
    std::vector<CrossingRock> rocks = even_rocks(97);
    rocks.push_back(rock(30.0, 9.0, 50.0));
    rocks.push_back(rock(30.0, 1.0, 3000.0));
    rocks.push_back(rock(55.0, 1.0, 50.0));
    const auto net = design_net(rocks, 0.95, 60.0);
    ASSERT_TRUE(net);
    EXPECT_LE(net->capacity_kj, 250.0);
    EXPECT_LT(net->height_m, 2.0);
    EXPECT_LT(net->to_m, 50.0);
    const Left left = left_below(rocks, *net);
    EXPECT_GE(left.kept.part, 95U);
    EXPECT_EQ(left.largest_kj, 3010.0);
}

TEST(DesignNet, OfTheOpenClassHasTheEnergyNeeded) {
    std::vector<CrossingRock> rocks;
    for (int i = 0; i < 40; ++i) {
        rocks.push_back(rock(10.0, 2.0, 5020.0));
    }
    const auto net = design_net(rocks, 0.95, 30.0);
    ASSERT_TRUE(net);
    EXPECT_EQ(net->energy_class, "8");
    EXPECT_EQ(net->capacity_kj, 5100.0);
    EXPECT_GE(net->length_m(), 5.0);
}

TEST(DesignNet, IsNoneOfTooFewRocks) {
    EXPECT_FALSE(design_net(even_rocks(19), 0.95, 60.0));
    EXPECT_TRUE(design_net(even_rocks(20), 0.95, 60.0));
}

TEST(DesignNet, HoldsTheShareOfThoseThatCrossWhereManyComePast) {
    std::vector<CrossingRock> rocks = even_rocks(50);
    for (int i = 0; i < 50; ++i) {
        rocks.push_back({{}, 90.0});  // released below the candidate
    }
    const auto net = design_net(rocks, 0.95, 60.0);
    ASSERT_TRUE(net);
    const Left left = left_below(rocks, *net);
    EXPECT_GE(left.kept.part, 48U);  // 95 % of 50, rounded up
    EXPECT_NEAR(left.energy_percent, 50.0, 5.0);
}

TEST(LeftBelow, CountsARockThatComesBackToTheNet) {
    const CrossingRock twice{{{10.0, 5.0, 50.0}, {10.0, 1.0, 40.0}}, 60.0};
    const NetDesign net{0.0, 20.0, "0", 100.0, 2.0};
    EXPECT_EQ(left_below(std::vector{twice}, net).kept.part, 1U);
    const CrossingRock breaks{{{10.0, 1.0, 150.0}, {10.0, 1.0, 40.0}}, 160.0};
    const Left left = left_below(std::vector{breaks}, net);
    EXPECT_EQ(left.kept.part, 0U);
    EXPECT_EQ(left.energy_kj, 160.0);
}

RC_GTEST_PROP(DesignNet, KeepsTheWantedShareOfAnyRocks, (const std::vector<std::uint32_t>& seeds)) {
    std::vector<CrossingRock> rocks;
    for (const std::uint32_t seed : seeds) {
        rocks.push_back(rock(seed % 100, 0.1 * (seed / 100 % 80), 1.0 + seed / 8000 % 6000));
    }
    const auto net = design_net(rocks, 0.9, 100.0);
    RC_ASSERT(net.has_value() == (rocks.size() >= 10));
    if (net) {
        const Left left = left_below(rocks, *net);
        RC_ASSERT(static_cast<double>(left.kept.part) >=
                  std::ceil(0.9 * static_cast<double>(rocks.size()) - 1e-9));
        RC_ASSERT(net->from_m >= 0.0 && net->to_m <= 100.0 && net->from_m < net->to_m);
    }
}

}  // namespace
}  // namespace coupling::siting::net_design_test
