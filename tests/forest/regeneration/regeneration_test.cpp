#include "forest/regeneration/regeneration.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "forest/saplings/saplings.hpp"
#include "tests/forest/small_forest.hpp"

namespace forest::regeneration_test {
namespace {

/// A dense old spruce stand, but for a slit of two by five patches in the middle.
Stand stand_with_slit(const SmallForest& forest) {
    StandRecord record;
    for (std::uint32_t i = 0; i < forest.grid.size(); ++i) {
        record.patches.push_back(PatchId{i});
    }
    record.species = {{.species = *forest.species.find("piab"), .stems_pha = 700.0, .mean_dbh_cm = 32.0}};
    record.degree_days = 1300.0;
    std::vector<Tree> trees = trees_from_record(record, forest.grid, forest.species, 1, 0, 0);
    std::erase_if(trees, [](const Tree& tree) {
        return tree.x_m > 40.0 && tree.x_m < 90.0 && tree.y_m > 50.0 && tree.y_m < 70.0;
    });
    return {forest.grid, forest.species.size(), trees, 2000};
}

bool in_slit(const PatchGrid& grid, PatchId patch) {
    return grid.x_centre_m(patch) > 40.0 && grid.x_centre_m(patch) < 90.0 && grid.y_centre_m(patch) > 50.0 &&
           grid.y_centre_m(patch) < 70.0;
}

TEST(Regenerate, FillsASlitWithinADozenYears) {
    const SmallForest forest{square_of_forest(12)};
    Stand stand = stand_with_slit(forest);
    for (int year = 0; year < 12; ++year) {
        static_cast<void>(forest.grow(stand));
    }
    double in = 0.0;
    double tallest_m = 0.0;
    double outside = 0.0;
    for (const Cohort& cohort : stand.cohorts()) {
        if (cohort.height_m > 0.3) {
            (in_slit(forest.grid, cohort.patch) ? in : outside) += cohort.stems;
        }
        tallest_m = std::max(tallest_m, cohort.height_m);
    }
    constexpr double slit_patches = 10.0;
    EXPECT_GT(in / slit_patches, 10.0) << "a thousand a hectare";
    // Fir and beech grow in the shade, too.
    EXPECT_GT(in / slit_patches, 3.0 * outside / (144.0 - slit_patches));
    EXPECT_GT(tallest_m, 0.5);
}

/// Open patches under a given light, some years without trees.
Stand years_under(const SmallForest& forest, double ground_light, double deer, int years,
                  std::uint16_t fenced_years = 0, std::size_t fenced_patches = 0) {
    Stand stand{forest.grid, forest.species.size(), {}, 2000};
    std::vector<PatchState> states(stand.patch_states().begin(), stand.patch_states().end());
    for (PatchState& state : states) {
        state.ground_light = ground_light;
    }
    for (std::size_t p = 0; p < fenced_patches; ++p) {
        states[p].fenced_years = fenced_years;
    }
    RegenerationLaw law;
    law.browsing_pressure = deer;
    for (int year = 0; year < years; ++year) {
        stand.begin_year();
        stand.set_patch_states(states);
        regenerate(stand, forest.site, forest.species, forest.weather,
                   SpeciesDrought{stand.grid().size(), forest.species.size()}, law, 1, 0);
        for (std::size_t p = 0; p < states.size(); ++p) {
            states[p].fenced_years = stand.patch_states()[p].fenced_years;
        }
    }
    return stand;
}

double taller_than(const Stand& stand, SpeciesId species, double height_m) {
    double stems = 0.0;
    for (const Cohort& cohort : stand.cohorts()) {
        stems += cohort.species == species && cohort.height_m > height_m ? cohort.stems : 0.0;
    }
    for (const Tree& tree : stand.trees()) {
        stems += tree.species == species ? tree.stems : 0.0;
    }
    return stems;
}

TEST(Regenerate, BringsPineAndNoSpruceWhereOnlyPineHasWater) {
    const SmallForest forest{square_of_forest(6)};
    const SpeciesId spruce = *forest.species.find("piab");
    const SpeciesId pine = *forest.species.find("pisy");
    Stand stand{forest.grid, forest.species.size(), {}, 2000};
    std::vector<PatchState> states(stand.patch_states().begin(), stand.patch_states().end());
    SpeciesDrought drought{forest.grid.size(), forest.species.size()};
    for (std::uint32_t p = 0; p < states.size(); ++p) {
        states[p].ground_light = 0.8;
        drought.set(PatchId{p}, spruce, 0.3);
        drought.set(PatchId{p}, pine, 0.8);
    }
    for (int year = 0; year < 10; ++year) {
        stand.begin_year();
        stand.set_patch_states(states);
        regenerate(stand, forest.site, forest.species, forest.weather, drought, {}, 1, 0);
    }
    EXPECT_EQ(taller_than(stand, spruce, 0.0), 0.0);
    EXPECT_GT(taller_than(stand, pine, 0.0), 50.0);
}

TEST(Regenerate, BringsFirWhereItIsTooDarkForSpruceAndLarch) {
    const SmallForest forest{square_of_forest(6)};
    const Stand stand = years_under(forest, 0.09, 0.0, 15);
    EXPECT_GT(taller_than(stand, *forest.species.find("abal"), 0.0), 100.0);
    EXPECT_EQ(taller_than(stand, *forest.species.find("piab"), 0.0), 0.0);
    EXPECT_EQ(taller_than(stand, *forest.species.find("lade"), 0.0), 0.0);
}

TEST(Regenerate, UnderManyDeerLosesFirAndRowanAndKeepsSpruce) {
    constexpr int years = 30;  // until rowan has grown out of reach
    const SmallForest forest{square_of_forest(6)};
    const Stand fenced = years_under(forest, 0.6, 0.0, years);
    const Stand browsed = years_under(forest, 0.6, 3.0, years);
    for (const char* tasty : {"abal", "soau"}) {
        const SpeciesId species = *forest.species.find(tasty);
        EXPECT_GT(taller_than(fenced, species, 0.6), 10.0) << tasty;
        EXPECT_LT(taller_than(browsed, species, 0.6), 0.6 * taller_than(fenced, species, 0.6)) << tasty;
        EXPECT_GT(taller_than(years_under(forest, 0.6, 1.0, years), species, 0.6),
                  taller_than(browsed, species, 0.6))
            << tasty << " under usual browsing";
    }
    const SpeciesId spruce = *forest.species.find("piab");
    EXPECT_GT(taller_than(browsed, spruce, 1.3), 0.8 * taller_than(fenced, spruce, 1.3));
}

TEST(Regenerate, BehindAFenceIsNotBrowsedUntilItIsTakenDown) {
    const SmallForest forest{square_of_forest(6)};
    const SpeciesId fir = *forest.species.find("abal");
    const auto firs = [&](const Stand& stand, bool fenced) {
        double stems = 0.0;
        for (const Cohort& cohort : stand.cohorts()) {
            stems += cohort.species == fir && cohort.height_m > 0.6 && (index_of(cohort.patch) < 18) == fenced
                         ? cohort.stems
                         : 0.0;
        }
        for (const Tree& tree : stand.trees()) {
            stems += tree.species == fir && (index_of(tree.patch) < 18) == fenced ? tree.stems : 0.0;
        }
        return stems;
    };
    const Stand half = years_under(forest, 0.6, 3.0, 20, 20, 18);
    EXPECT_GT(firs(half, true), 5.0);
    EXPECT_LT(firs(half, false), 0.3 * firs(half, true));
    EXPECT_EQ(half.patch_states()[0].fenced_years, 0);
    // No deer on one side is what no deer at all would be.
    EXPECT_EQ(taller_than(years_under(forest, 0.6, 3.0, 20, 20, 36), fir, 0.6),
              taller_than(years_under(forest, 0.6, 0.0, 20), fir, 0.6));
    // One that stands for two years only helps little.
    EXPECT_LT(firs(years_under(forest, 0.6, 3.0, 20, 2, 18), true), 0.4 * firs(half, true));
}

TEST(Regenerate, KeepsTheBalanceOfSaplingsAndTrees) {
    const SmallForest forest{square_of_forest(8)};
    Stand stand{forest.grid, forest.species.size(), {}, 2000};
    for (int year = 0; year < 40; ++year) {
        static_cast<void>(forest.grow(stand));
        const StandBalance balance = stand.total_balance();
        ASSERT_EQ(balance.saplings_in,
                  balance.all_saplings_out() + balance.saplings_recruited + stand.saplings_standing());
        ASSERT_EQ(balance.all_stems_in(), balance.all_stems_out() + stand.stems_standing());
        ASSERT_EQ(balance.all_stems_in(), balance.saplings_recruited);
    }
    EXPECT_GT(stand.trees().size(), 20U) << "open ground becomes forest";
    for (const Tree& tree : stand.trees()) {
        EXPECT_GE(tree.dbh_cm, 1.0);
        EXPECT_GE(tree.height_m, recruitment_height_m);
        EXPECT_TRUE(tree.stems == 1 || tree.dbh_cm < 5.0 + 3.0);
    }
}

TEST(Regenerate, LeavesNoPatchDenserThanTheLine) {
    const SmallForest forest{square_of_forest(6)};
    Stand stand{forest.grid, forest.species.size(), {}, 2000};
    for (int year = 0; year < 12; ++year) {
        static_cast<void>(forest.grow(stand));
        std::vector<double> room(forest.grid.size(), 0.0);
        for (const Cohort& cohort : stand.cohorts()) {
            room[index_of(cohort.patch)] += cohort.stems * room_of_stem(cohort.height_m);
        }
        // One stem of each species may be more: parts of a stem are decided by chance.
        EXPECT_LE(*std::max_element(room.begin(), room.end()), 1.0 + 11.0 / 230.0);
    }
}

TEST(Regenerate, GivesTheSameBytesForAnyOrderOfTrees) {
    const SmallForest forest{square_of_forest(6)};
    std::vector<Tree> trees = any_trees(forest.grid, forest.species, 60, 4);
    Stand straight{forest.grid, forest.species.size(), trees, 2000};
    std::reverse(trees.begin(), trees.end());
    Stand permuted{forest.grid, forest.species.size(), trees, 2000};
    for (int year = 0; year < 15; ++year) {
        static_cast<void>(forest.grow(straight));
        static_cast<void>(forest.grow(permuted));
    }
    ASSERT_GT(straight.cohorts().size(), 100U);
    ASSERT_EQ(straight.cohorts().size(), permuted.cohorts().size());
    for (std::size_t i = 0; i < straight.cohorts().size(); ++i) {
        EXPECT_EQ(straight.cohorts()[i].stems, permuted.cohorts()[i].stems);
        EXPECT_EQ(straight.cohorts()[i].height_m, permuted.cohorts()[i].height_m);
    }
    EXPECT_EQ(straight.total_balance().saplings_recruited, permuted.total_balance().saplings_recruited);
}

TEST(Regenerate, SproutsFromLastYearsStumpsOfSpeciesThatCan) {
    const SmallForest forest{square_of_forest(2)};
    Stand stand{forest.grid, forest.species.size(), {}, 2000};
    const auto stump = [&](const char* code, double dbh_cm, int year) {
        return Snag{.x_m = 5.0,
                    .y_m = 5.0,
                    .species = *forest.species.find(code),
                    .cut = true,
                    .dbh_cm = dbh_cm,
                    .tree_height_m = 15.0,
                    .height_m = 0.3,
                    .year = year};
    };
    stand.add_snags(std::vector<Snag>{stump("fasy", 20.0, 2000), stump("fasy", 40.0, 2000),
                                      stump("piab", 20.0, 2000), stump("acps", 20.0, 1999)});
    stand.begin_year();
    const std::vector<Cohort> sprouts = sprouts_of(stand, forest.species);
    ASSERT_EQ(sprouts.size(), 1U);
    EXPECT_EQ(sprouts[0].species, *forest.species.find("fasy"));
    EXPECT_EQ(sprouts[0].stems, 3U);
    EXPECT_EQ(sprouts[0].origin, Origin::sprout);
}

}  // namespace
}  // namespace forest::regeneration_test
