#include "forest/disturbance/snow_breakage.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/forest/small_forest.hpp"

namespace forest::snow_breakage_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const SpeciesId spruce = *table.find("piab");

/// A square whose ground lies at one height, with equal trees on its first patch.
Stand equal_trees(double ground_m, SpeciesId species, double dbh_cm, double height_m, std::size_t count) {
    const PatchGrid slope = square_of_forest(1);
    std::vector<Patch> patches = slope.patches();
    patches[0].ground_m = ground_m;
    std::vector<Tree> trees(count, new_tree(table[species], species, 5.0, 5.0, dbh_cm, height_m, 60.0));
    for (std::size_t i = 0; i < count; ++i) {
        trees[i].id = TreeId{i};
    }
    Stand stand{{slope.frame(), patches}, table.size(), trees, 2000};
    stand.begin_year();
    return stand;
}

TEST(SnowBreakage, TakesSlenderConifers) {
    EXPECT_NEAR(snow_breakage(table[spruce], 20.0, 16.0), 1.0 / (1.0 + std::exp(2.4)), 1e-9);
    EXPECT_GT(snow_breakage(table[spruce], 20.0, 22.0), snow_breakage(table[spruce], 20.0, 16.0));
    EXPECT_GT(snow_breakage(table[spruce], 18.0, 16.0), snow_breakage(table[spruce], 20.0, 16.0));
    EXPECT_EQ(snow_breakage(table[*table.find("fasy")], 20.0, 22.0), 0.0);
}

TEST(BreakBySnow, BreaksTheShareThatItsChanceSays) {
    constexpr std::size_t count = 10'000;
    Stand stand = equal_trees(1000.0, spruce, 20.0, 18.0, count);
    break_by_snow(stand, table, 1.0, 1, 0);
    const double p = snow_breakage(table[spruce], 20.0, 18.0);
    const auto broken = static_cast<double>(count - stand.trees().size());
    EXPECT_NEAR(broken / count, p, 4.0 * std::sqrt(p * (1.0 - p) / count));
    EXPECT_EQ(stand.balance().stems_out[index_of(Cause::snow)], broken);
    ASSERT_EQ(static_cast<double>(stand.dead_wood().snags.size()), broken);
    for (std::size_t i = 0; i < stand.dead_wood().snags.size(); ++i) {
        const double stump_m = stand.dead_wood().snags[i].height_m;
        EXPECT_GE(stump_m, 6.0);
        EXPECT_LE(stump_m, 12.0);
        EXPECT_NEAR(stand.dead_wood().logs[i].length_m, 18.0 - stump_m, 1e-9);
    }
}

TEST(BreakBySnow, StaysBetweenItsElevationsAndOffThinStems) {
    for (const double ground_m : {499.0, 1301.0}) {
        Stand stand = equal_trees(ground_m, spruce, 20.0, 22.0, 200);
        break_by_snow(stand, table, 1.0, 1, 0);
        EXPECT_EQ(stand.trees().size(), 200U) << ground_m;
    }
    Stand thin = equal_trees(1000.0, spruce, 9.0, 14.0, 200);
    break_by_snow(thin, table, 1.0, 1, 0);
    EXPECT_EQ(thin.trees().size(), 200U);
}

TEST(BreakBySnow, ComesInAsManyYearsAsItsChanceSays) {
    constexpr int replicates = 5000;
    constexpr double p = 0.05;
    int snowy = 0;
    for (std::uint32_t replicate = 0; replicate < replicates; ++replicate) {
        Stand stand = equal_trees(1000.0, spruce, 20.0, 30.0, 3);
        break_by_snow(stand, table, p, 1, replicate);
        snowy += stand.trees().empty() ? 1 : 0;
    }
    // At a slenderness of 150 three of 100 stems hold: all three break in 0.92 of the snowy years.
    const double all = std::pow(snow_breakage(table[spruce], 20.0, 30.0), 3.0) * p;
    EXPECT_NEAR(snowy / static_cast<double>(replicates), all,
                4.0 * std::sqrt(all * (1.0 - all) / replicates));
}

}  // namespace
}  // namespace forest::snow_breakage_test
