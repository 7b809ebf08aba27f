#include "forest/disturbance/snow_breakage.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "forest/disturbance/wet_snow.hpp"
#include "tests/forest/small_forest.hpp"

namespace forest::snow_breakage_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const SpeciesId spruce = *table.find("piab");

const SmallForest patch{square_of_forest(1)};

/// Equal trees on a patch.
Stand equal_trees(SpeciesId species, double dbh_cm, double height_m, std::size_t count) {
    std::vector<Tree> trees(count, new_tree(table[species], species, 5.0, 5.0, dbh_cm, height_m, 60.0));
    for (std::size_t i = 0; i < count; ++i) {
        trees[i].id = TreeId{i};
    }
    Stand stand{patch.grid, table.size(), trees, 2000};
    stand.begin_year();
    return stand;
}

/// Wet snow of that many usual years.
void let_it_snow(Stand& stand, double times_usual, double usual_chance, std::uint32_t replicate) {
    std::vector<ClimateYear> weather{montane_year()};
    const double scale = times_usual * usual_wet_snow_mm / wet_snow_mm(weather[0]);
    for (ClimateMonth& month : weather[0].months) {
        month.prec_mm *= scale;
    }
    break_by_snow(stand, patch.site, table, weather, usual_chance, 1, replicate);
}

TEST(SnowBreakage, TakesSlenderConifers) {
    EXPECT_NEAR(snow_breakage(table[spruce], 20.0, 16.0), 1.0 / (1.0 + std::exp(4.9)), 1e-9);
    EXPECT_GT(snow_breakage(table[spruce], 20.0, 22.0), snow_breakage(table[spruce], 20.0, 16.0));
    EXPECT_GT(snow_breakage(table[spruce], 18.0, 16.0), snow_breakage(table[spruce], 20.0, 16.0));
    EXPECT_EQ(snow_breakage(table[*table.find("fasy")], 20.0, 22.0), 0.0);
}

TEST(BreakBySnow, BreaksTheShareThatItsChanceSays) {
    constexpr std::size_t count = 10'000;
    Stand stand = equal_trees(spruce, 20.0, 18.0, count);
    let_it_snow(stand, 1.0, 1.0, 0);
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

TEST(BreakBySnow, NeedsWetSnowAndStaysOffThinStems) {
    Stand dry = equal_trees(spruce, 20.0, 22.0, 200);
    let_it_snow(dry, 0.0, 1.0, 0);
    EXPECT_EQ(dry.trees().size(), 200U);
    Stand thin = equal_trees(spruce, 9.0, 14.0, 200);
    let_it_snow(thin, 1.0, 1.0, 0);
    EXPECT_EQ(thin.trees().size(), 200U);
}

TEST(BreakBySnow, ComesInAsManyYearsAsItsChanceSays) {
    constexpr int replicates = 5000;
    constexpr double p = 0.05;
    int snowy = 0;
    for (std::uint32_t replicate = 0; replicate < replicates; ++replicate) {
        Stand stand = equal_trees(spruce, 20.0, 40.0, 3);
        let_it_snow(stand, 1.0, p, replicate);
        snowy += stand.trees().empty() ? 1 : 0;
    }
    // At a slenderness of 200 three of 100 stems hold: all three break in 0.91 of the snowy years.
    const double all = std::pow(snow_breakage(table[spruce], 20.0, 40.0), 3.0) * p;
    EXPECT_NEAR(snowy / static_cast<double>(replicates), all,
                4.0 * std::sqrt(all * (1.0 - all) / replicates));
}

}  // namespace
}  // namespace forest::snow_breakage_test
