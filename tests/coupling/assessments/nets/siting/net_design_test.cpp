#include "coupling/assessments/nets/siting/net_design.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <optional>

namespace coupling::siting::net_design_test {
namespace {

CrossingRock rock(double along_m, double height_m, double energy_kj) {
    return {{{along_m, height_m, energy_kj}}, energy_kj + 10.0};
}

/// The same rocks as all that cross the line, with a radius of 0.3 m.
std::vector<PassingRock> crossings_of(const std::vector<CrossingRock>& rocks) {
    std::vector<PassingRock> all;
    std::uint32_t path = 0;
    for (const CrossingRock& rock : rocks) {
        ++path;
        for (const Crossing& crossing : rock.crossings) {
            all.push_back({path, static_cast<float>(crossing.along_m),
                           static_cast<float>(1000.0 * crossing.energy_kj),
                           static_cast<float>(crossing.height_m), 0.3F});
        }
    }
    return all;
}

std::optional<NetDesign> design(const std::vector<CrossingRock>& rocks, double share, double line_m) {
    NetWish wish;
    wish.share = share;
    wish.design.percentile = 100.0 * share;
    return design_net(rocks, crossings_of(rocks), wish, line_m);
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
    const auto net = design(rocks, 0.95, 60.0);
    ASSERT_TRUE(net);
    EXPECT_EQ(net->energy_class, "0");     // 100 kJ
    EXPECT_DOUBLE_EQ(net->height_m, 1.5);  // 1 m and the radius, as sold
    EXPECT_TRUE(net->sold_height_m.has_value());
    EXPECT_GE(net->from_m, 19.0);
    EXPECT_LE(net->to_m, 40.0);
    EXPECT_GE(left_below(rocks, *net).kept.part, 95U);
}

TEST(DesignNet, LeavesTheFewStrongAndHighRocks) {
    std::vector<CrossingRock> rocks = even_rocks(97);
    rocks.push_back(rock(30.0, 9.0, 50.0));
    rocks.push_back(rock(30.0, 1.0, 3000.0));
    rocks.push_back(rock(55.0, 1.0, 50.0));
    const auto net = design(rocks, 0.95, 60.0);
    ASSERT_TRUE(net);
    EXPECT_LE(net->capacity_kj, 250.0);
    EXPECT_LT(net->height_m, 2.0);
    EXPECT_LT(net->to_m, 50.0);
    const Left left = left_below(rocks, *net);
    EXPECT_GE(left.kept.part, 95U);
    EXPECT_EQ(left.largest_kj, 3010.0);
    EXPECT_EQ(left.over, 1U);
    EXPECT_EQ(left.through, 1U);
    EXPECT_EQ(left.kept.part + left.over + left.through + left.beside, rocks.size());
}

TEST(DesignNet, OfTheOpenClassHasTheEnergyNeeded) {
    std::vector<CrossingRock> rocks;
    for (int i = 0; i < 40; ++i) {
        rocks.push_back(rock(10.0, 2.0, 5020.0));
    }
    const auto net = design(rocks, 0.95, 30.0);
    ASSERT_TRUE(net);
    EXPECT_EQ(net->energy_class, "8");
    EXPECT_EQ(net->capacity_kj, 5100.0);
    EXPECT_GE(net->length_m(), 5.0);
}

TEST(DesignNet, IsNoneOfTooFewRocks) {
    EXPECT_FALSE(design(even_rocks(19), 0.95, 60.0));
    EXPECT_TRUE(design(even_rocks(20), 0.95, 60.0));
}

TEST(DesignNet, HoldsTheShareOfThoseThatCrossWhereManyComePast) {
    std::vector<CrossingRock> rocks = even_rocks(50);
    for (int i = 0; i < 50; ++i) {
        rocks.push_back({{}, 90.0});  // released below the candidate
    }
    const auto net = design(rocks, 0.95, 60.0);
    ASSERT_TRUE(net);
    const Left left = left_below(rocks, *net);
    EXPECT_GE(left.kept.part, 48U);  // 95 % of 50, rounded up
    EXPECT_NEAR(left.energy_percent, 50.0, 5.0);
    EXPECT_GE(left.beside, 50U);
}

TEST(LeftBelow, CountsARockThatComesBackToTheNet) {
    const CrossingRock twice{{{10.0, 5.0, 50.0}, {10.0, 1.0, 40.0}}, 60.0};
    const NetDesign net{{"0", 100.0, 2.0, 2.0}, 0.0, 20.0};
    EXPECT_EQ(left_below(std::vector{twice}, net).kept.part, 1U);
    const CrossingRock breaks{{{10.0, 1.0, 150.0}, {10.0, 1.0, 40.0}}, 160.0};
    const Left left = left_below(std::vector{breaks}, net);
    EXPECT_EQ(left.kept.part, 0U);
    EXPECT_EQ(left.energy_kj, 160.0);
}

TEST(PassagesWithin, TakeEachRockAsItFirstComesToThePiece) {
    const std::vector<PassingRock> crossings{{1, 5.0F, 1e4F, 1.0F, 0.3F},
                                             {1, 15.0F, 2e4F, 2.0F, 0.3F},
                                             {1, 16.0F, 3e4F, 3.0F, 0.3F},
                                             {2, 12.0F, 4e4F, 4.0F, 0.4F}};
    const std::vector<Passage> passages = passages_within(crossings, 10.0, 20.0);
    ASSERT_EQ(passages.size(), 2U);
    EXPECT_EQ(passages[0].energy_kj, 20.0);
    EXPECT_EQ(passages[1].energy_kj, 40.0);
    EXPECT_EQ(passages[1].top_m(), 4.0 + static_cast<double>(0.4F));
}

RC_GTEST_PROP(DesignNet, LosesNoMoreThanEachOfItsMargins, (const std::vector<std::uint32_t>& seeds)) {
    std::vector<CrossingRock> rocks;
    for (const std::uint32_t seed : seeds) {
        rocks.push_back(rock(seed % 100, 0.1 * (seed / 100 % 80), 1.0 + seed / 8000 % 6000));
    }
    const auto net = design(rocks, 0.9, 100.0);
    if (rocks.size() < 10) {
        RC_ASSERT(!net);
    }
    if (net) {
        const auto count = static_cast<double>(rocks.size());
        const Left left = left_below(rocks, *net);
        RC_ASSERT(static_cast<double>(left.over) <= 0.1 * count);
        RC_ASSERT(static_cast<double>(left.through) <= 0.1 * count);
        RC_ASSERT(static_cast<double>(left.beside) <= 0.1 * count);
        RC_ASSERT(left.kept.part + left.over + left.through + left.beside == rocks.size());
        RC_ASSERT(net->from_m >= 0.0 && net->to_m <= 100.0 && net->from_m < net->to_m);
    }
}

}  // namespace
}  // namespace coupling::siting::net_design_test
