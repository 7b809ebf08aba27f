#include "forest/light/stand_light.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "tests/forest/small_forest.hpp"

namespace forest::stand_light_test {
namespace {

StandLight light_of(const SmallForest& forest, const Stand& stand) {
    const LightYear year = light_year_of(forest.site, forest.species, {forest.weather, 350.0, false});
    const std::vector<LightTree> trees = light_trees_of(stand, forest.species);
    const Canopy canopy{forest.site.light().ground(), trees};
    return light_in_stand(stand, forest.species, forest.site.light(), canopy,
                          compute_light(forest.site.light(), canopy, year, trees));
}

Stand stand_of(const SmallForest& forest, std::vector<Tree> trees) {
    return {forest.grid, forest.species.size(), std::move(trees), 2000};
}

/// Some years on their way.
std::vector<Tree> older(const SmallForest& forest, const std::vector<Tree>& trees, int years) {
    Stand stand = stand_of(forest, trees);
    for (int year = 0; year < years; ++year) {
        static_cast<void>(forest.grow(stand));
    }
    return {stand.trees().begin(), stand.trees().end()};
}

TEST(LightInStand, DarkensNobodyWhenANeighbourGoes) {
    // In the light of cells alone nobody loses a hair (tests/forest/light). That within cells is interpolated
    // between the cells of a column: a leaf less moves its nodes, rarely by more than 0.01; 0.036 is the most
    // that was seen.
    constexpr double interpolation = 0.1;
    const SmallForest forest{square_of_forest(4)};
    EXPECT_TRUE(rc::check("all others have as much light or more", [&] {
        const auto stems_pha = static_cast<double>(*rc::gen::inRange(200, 2000));
        const auto seed = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000));
        const std::vector<Tree> trees =
            older(forest, mixed_stand(forest, stems_pha, seed), *rc::gen::inRange(0, 4));
        const auto gone = *rc::gen::inRange<std::size_t>(0, trees.size());
        std::vector<Tree> rest = trees;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(gone));
        const StandLight before = light_of(forest, stand_of(forest, trees));
        const StandLight after = light_of(forest, stand_of(forest, rest));
        double gained = 0.0;
        for (std::size_t i = 0; i < rest.size(); ++i) {
            const double was = before.ratios[i < gone ? i : i + 1];
            RC_ASSERT(after.ratios[i] >= 0.0 && after.ratios[i] <= 1.0);
            RC_ASSERT(after.ratios[i] >= was - interpolation);
            gained += after.ratios[i] - was;
        }
        // All together lose no more than the one tree that loses most may.
        RC_ASSERT(gained > -interpolation);
    }));
}

TEST(LightInStand, GivesSmallTreesOfACellLessThanTallOnes) {
    const SmallForest forest{square_of_forest(3)};
    const SpeciesId spruce = *forest.species.find("piab");
    std::vector<Tree> trees;
    for (std::size_t i = 0; i < 36; ++i) {
        const double dbh_cm = i % 2 == 0 ? 12.0 : 7.0;
        trees.push_back(new_tree(forest.species[spruce], spruce, 2.5 + 5.0 * static_cast<double>(i % 6),
                                 2.5 + 5.0 * static_cast<double>(i / 6), dbh_cm, dbh_cm, 40.0));
        trees.back().id = TreeId{i};
    }
    const StandLight light = light_of(forest, stand_of(forest, trees));
    for (std::size_t i = 0; i < 36; i += 2) {
        EXPECT_GT(light.ratios[i], light.ratios[i + 1]) << i;
    }
}

TEST(LightByLayers, AbsorbsNoMoreThanFallsOnTheGroundAndNothingWithoutLeaves) {
    const SmallForest forest{square_of_forest(4, 0.0)};
    const Stand stand = stand_of(forest, mixed_stand(forest, 2000.0, 1));
    const LightYear year = light_year_of(forest.site, forest.species, {.units = forest.weather});
    const StandLight light = light_by_layers(stand, forest.species, year.radiation);
    constexpr std::size_t july = 6;
    constexpr std::size_t january = 0;
    const double falls_mj =
        stand.grid().area_m2() * (year.radiation.direct_mjpm2[july] + year.radiation.diffuse_mjpm2[july]);
    double absorbed_mj = 0.0;
    for (std::size_t i = 0; i < stand.trees().size(); ++i) {
        absorbed_mj += light.absorbed[i][july];
        EXPECT_GE(light.ratios[i], 0.0);
        EXPECT_LE(light.ratios[i], 1.0);
        const bool bare = !forest.species[stand.trees()[i].species].light.in_leaf(1);
        EXPECT_EQ(light.absorbed[i][january] == 0.0, bare);
    }
    EXPECT_GT(absorbed_mj, 0.5 * falls_mj);
    EXPECT_LE(absorbed_mj, falls_mj * (1.0 + 1e-12));
}

}  // namespace
}  // namespace forest::stand_light_test
