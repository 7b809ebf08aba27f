#include "forest/regeneration/ground_cover.hpp"

#include <gtest/gtest.h>

#include "tests/forest/small_forest.hpp"

namespace forest::ground_cover_test {
namespace {

TEST(AfterYearOfHerbs, SpreadsThemFromTheSecondOpenYearOnAndDarkensThemAway) {
    PatchState state;
    state.ground_light = 0.8;
    state = after_year_of_herbs(state);
    EXPECT_EQ(state.herb_cover, 0.0F);
    for (int year = 0; year < 4; ++year) {
        state = after_year_of_herbs(state);
    }
    EXPECT_FLOAT_EQ(state.herb_cover, 1.0F);
    state.ground_light = 0.2;
    EXPECT_FLOAT_EQ(after_year_of_herbs(state).herb_cover, 1.0F);
    state.ground_light = 0.1;
    EXPECT_EQ(after_year_of_herbs(state).herb_cover, 0.0F);
}

/// A stem of 20 m whose ends are 50 and 10 cm thick, on the first patch: 6 m2 of ground.
Log lying(const PatchGrid& grid, LogOrigin origin, int year, double density_share) {
    return {.x_m = grid.x_centre_m(PatchId{0}),
            .y_m = grid.y_centre_m(PatchId{0}),
            .length_m = 20.0,
            .thick_end_cm = 50.0,
            .thin_end_cm = 10.0,
            .density_share = density_share,
            .origin = origin,
            .year = year};
}

Stand with_logs(const SmallForest& forest, const std::vector<Log>& logs) {
    Stand stand{forest.grid, forest.species.size(), {}, 2000};
    stand.add_logs(logs);
    stand.begin_year();
    return stand;
}

TEST(GroundCovers, AreLogsThatAreABedOnceTheyAreRottenAndNoneBefore) {
    const SmallForest forest{square_of_forest(2)};
    const Stand rotten = with_logs(forest, {lying(forest.grid, LogOrigin::fallen, 1970, 0.4)});
    EXPECT_NEAR(ground_covers(rotten)[0].rotten_wood, 0.06, 1e-12);
    EXPECT_EQ(ground_covers(rotten)[0].fresh_wood, 0.0);
    EXPECT_EQ(ground_covers(rotten)[1].rotten_wood, 0.0);
    const Stand hard = with_logs(forest, {lying(forest.grid, LogOrigin::fallen, 1980, 0.8)});
    EXPECT_NEAR(ground_covers(hard)[0].fresh_wood, 0.06, 1e-12);
    const Stand with_branches = with_logs(forest, {lying(forest.grid, LogOrigin::fallen, 1995, 0.9)});
    EXPECT_NEAR(ground_covers(with_branches)[0].fresh_wood, 0.12, 1e-12);
}

TEST(CrushedShares, AreUnderTreesThatFellInTheYearBefore) {
    const SmallForest forest{square_of_forest(2)};
    const Log thrown = lying(forest.grid, LogOrigin::windthrow, 2000, 1.0);
    EXPECT_NEAR(crushed_shares(with_logs(forest, {thrown}))[0], 0.1, 1e-12);
    EXPECT_NEAR(crushed_shares(with_logs(forest, {thrown, thrown}))[0], 1.0 - 0.9 * 0.9, 1e-12);
    EXPECT_EQ(crushed_shares(with_logs(forest, {lying(forest.grid, LogOrigin::windthrow, 1999, 1.0)}))[0],
              0.0);

    Stand felled{forest.grid, forest.species.size(), {}, 2000};
    felled.add_snags(std::vector<Snag>{{.x_m = forest.grid.x_centre_m(PatchId{0}),
                                        .y_m = forest.grid.y_centre_m(PatchId{0}),
                                        .cut = true,
                                        .dbh_cm = 50.0,
                                        .tree_height_m = 20.0,
                                        .height_m = 0.3,
                                        .year = 2000}});
    felled.begin_year();
    EXPECT_NEAR(crushed_shares(felled)[0], 0.1, 1e-12) << "a tree that was hauled has lain there, too";
}

}  // namespace
}  // namespace forest::ground_cover_test
