#include "coupling/exchange/regimes/apply.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "coupling/exchange/regimes/shipped.hpp"
#include "forest/inventory/tables.hpp"
#include "tests/coupling/exchange/regimes/worked.hpp"

namespace coupling::apply_test {
namespace {

TEST(Apply, AccountsForEveryKindOfCut) {
    for (const std::string table :
         {"treatment,share\nthin_below,0.25\n", "treatment,share,of_volume\nthin_below,0.25,yes\n",
          "treatment,target_density\nthin_density,0.4\n",
          "treatment,crop_trees_pha,competitors,a_value,most_volume_share\nthin_crop_trees,150,2,5,0.2\n",
          "treatment,from_dbh_cm\ntarget_diameter,40\n",
          "treatment,basal_area_m2pha,max_dbh_cm,q,most_volume_share\nselection,20,45,1.3,0.3\n",
          "treatment,share\nshelter_cut,0.4\n", "treatment,side_m,area_share\ngroup_cut,20,0.2\n",
          "treatment\nclear_cut\n", "treatment,where,width_m,angle_deg\nclear_cut,strips,20,0\n",
          "treatment,where,width_m,angle_deg,length_m,lines_m\nclear_cut,slits,10,45,30,30\n",
          "treatment,where,stands\nclear_cut,stands,2\n",
          "treatment,to_basal_area_m2pha\nthin_to_basal_area,10\n",
          "treatment,only_species\nclear_cut,piab\n", "treatment,girdled\nclear_cut,yes\n",
          "treatment,retain_pha\nclear_cut,50\n",
          "treatment,where,lines,width_m\nclear_cut,corridors,lines.csv,12\n",
          "treatment,where,polygons\nclear_cut,polygons,areas.csv\n"}) {
        SCOPED_TRACE(table);
        Worked{table}.expect_cut_is_accounted_for();
    }
}

TEST(Apply, CutsHowMuchTheTableSays) {
    const auto basal_area = [](const forest::Stand& stand) {
        return forest::figures_of(stand.trees(), species_table(), 1.0).basal_area_m2pha;
    };
    const double before = basal_area(spruce_stand(6));
    EXPECT_NEAR(basal_area(Worked{"treatment,share\nthin_below,0.25\n"}.stand), 0.75 * before, 0.01 * before);
    EXPECT_NEAR(basal_area(Worked{"treatment,share\nshelter_cut,0.4\n"}.stand), 0.6 * before, 0.02 * before);
    const Worked by_volume{"treatment,share,of_volume\nthin_below,0.25,yes\n"};
    EXPECT_NEAR(volume_m3(by_volume.stand), 0.75 * by_volume.before_m3, 0.01 * by_volume.before_m3);
    const Worked thick{"treatment,from_dbh_cm\ntarget_diameter,40\n"};
    for (const forest::Tree& tree : thick.stand.trees()) {
        EXPECT_LT(tree.dbh_cm, 40.0);
    }
    const Worked spared{"treatment,from_dbh_cm\nclear_cut,20\n"};
    EXPECT_GT(spared.stand.trees().size(), 10U);
    for (const forest::Tree& tree : spared.stand.trees()) {
        EXPECT_LT(tree.dbh_cm, 20.0);
    }
    EXPECT_TRUE(Worked{"treatment\nclear_cut\n"}.stand.trees().empty());
}

TEST(Apply, KeepsToItsGround) {
    const Worked half{"treatment,where,stands\nclear_cut,stands,2\n"};
    EXPECT_NEAR(half.report.entries[0].area_ha, 0.18, 1e-9);
    for (const forest::Tree& tree : half.stand.trees()) {
        EXPECT_LT(tree.x_m, 30.0);
    }
    const Worked holes{"treatment,side_m,area_share\ngroup_cut,20,0.2\n"};
    EXPECT_NEAR(holes.report.entries[0].area_ha, 0.04, 1e-9) << "one hole fits into a fifth of 0.36 ha";
    const Worked corner{"treatment,where,polygons\nclear_cut,polygons,areas.csv\n"};
    EXPECT_EQ(corner.report.entries[0].stems, 25.0);
}

TEST(Apply, LeavesLogsAndStumpsWhenTold) {
    const Worked worked{
        "treatment,left_share,log_length_m,log_angle_deg,anchored,stump_height_m\nclear_cut,0.5,6,60,no,1."
        "3\n"};
    const auto& dead = worked.stand.dead_wood();
    ASSERT_FALSE(dead.logs.empty());
    double thick = 0.0;
    for (const forest::Snag& stump : dead.snags) {
        EXPECT_TRUE(stump.cut);
        EXPECT_NEAR(stump.height_m, 1.3, 1e-9);
        thick += stump.dbh_cm >= 15.0 ? 1.0 : 0.0;
    }
    const double share = static_cast<double>(dead.logs.size()) / thick;
    EXPECT_NEAR(share, 0.5, 4.0 * std::sqrt(0.25 / thick));
    for (const forest::Log& log : dead.logs) {
        EXPECT_LE(log.length_m, 6.0 + 1e-9);
        EXPECT_FALSE(log.anchored);
        // The fall line points south.
        EXPECT_NEAR(-std::sin(log.direction_rad), 0.5, 1e-9);
    }
    EXPECT_GT(worked.report.entries[0].left_m3, 0.0);

    const Worked plain{"treatment\nclear_cut\n"};
    EXPECT_TRUE(plain.stand.dead_wood().logs.empty());
    EXPECT_NEAR(plain.stand.dead_wood().snags[0].height_m, forest::stump_height_m, 1e-9);
}

TEST(Apply, WoundsNeighboursWhenTold) {
    EXPECT_TRUE(Worked{"treatment,share\nthin_below,0.2\n"}.stand.wounds().empty());
    EXPECT_FALSE(Worked{"treatment,share,damage_share\nthin_below,0.2,0.5\n"}.stand.wounds().empty());
}

TEST(Apply, PlantsWhatItSaysAndOnlyWhereFewStand) {
    const Worked all{"treatment,species,plants_pha\nplant,piab abal,1500 500\n"};
    EXPECT_EQ(all.report.entries[0].plants, all.stand.saplings_standing());
    EXPECT_EQ(all.report.entries[0].plants, 540U + 180U);
    EXPECT_TRUE(books_close(all.stand));

    forest::Stand stand = spruce_stand(6);
    stand.add_cohorts(std::vector<forest::Cohort>{
        {.patch = forest::PatchId{0}, .species = species_of("piab"), .stems = 20, .height_m = 0.5},
        {.patch = forest::PatchId{1}, .species = species_of("piab"), .stems = 500, .height_m = 0.1}});
    const Worked some{"treatment,species,plants_pha,where_fewer_pha\nplant,piab abal,1500 500,1000\n", stand};
    EXPECT_EQ(some.report.entries[0].plants, 35U * 20U) << "seedlings of 0.1 m do not count yet";

    const Worked clusters{"treatment,species,spacing_m\nplant_clusters,lade,20\n"};
    EXPECT_EQ(clusters.report.entries[0].plants, 9U * 25U);
    const Worked nothing{
        "treatment,species,plants_pha,where_fewer_pha\nplant,piab,1500,1\n", [] {
            forest::Stand full = spruce_stand(1);
            full.add_cohorts(std::vector<forest::Cohort>{
                {.patch = forest::PatchId{0}, .species = species_of("piab"), .stems = 20, .height_m = 0.5}});
            return full;
        }()};
    EXPECT_TRUE(nothing.report.entries.at(0).found_nothing());
}

TEST(Apply, TendsForTheFavoured) {
    forest::Stand stand = spruce_stand(2);
    stand.add_cohorts(std::vector<forest::Cohort>{
        {.patch = forest::PatchId{0}, .species = species_of("abal"), .stems = 5, .height_m = 1.0},
        {.patch = forest::PatchId{0}, .species = species_of("piab"), .stems = 40, .height_m = 1.0},
        {.patch = forest::PatchId{1}, .species = species_of("piab"), .stems = 40, .height_m = 1.0}});
    const Worked worked{"treatment,share,species,from_height_m,to_height_m\ntend,0.5,abal,0.5,5\n", stand};
    EXPECT_EQ(worked.report.entries[0].tended, 20U);
    EXPECT_EQ(worked.stand.saplings_standing(), 65U);
}

TEST(Apply, SalvagesFreshDeadWood) {
    forest::Stand stand = spruce_stand(2);
    const forest::Snag snag{.tree = forest::TreeId{900},
                            .x_m = 5.0,
                            .y_m = 5.0,
                            .species = species_of("piab"),
                            .dbh_cm = 30.0,
                            .tree_height_m = 25.0,
                            .height_m = 25.0,
                            .year = 2000,
                            .sound_kg = 300.0};
    forest::Snag old = snag;
    old.year = 1990;
    stand.add_snags(std::vector<forest::Snag>{old, snag});
    const Worked worked{"treatment,share,oldest_years\nsalvage,1,2\n", stand};
    EXPECT_EQ(worked.report.entries[0].stems, 1.0);
    EXPECT_GT(worked.report.entries[0].taken_m3, 0.5);
    EXPECT_EQ(worked.stand.dead_wood().snags.size(), 2U) << "the old one, and a stump";
}

TEST(Apply, FellsATreeOnceAndPlantsLast) {
    // Thinning and the cut of target diameters see the same stand; planting comes after both though its row
    // is first.
    Worked worked{
        "name,treatment,share,from_dbh_cm,species,plants_pha\n"
        "young,plant,,,piab,1000\nall,clear_cut,,,,\nwood,salvage,1,,,\n"};
    ASSERT_EQ(worked.report.entries.size(), 3U);
    EXPECT_EQ(worked.report.entries[0].plants, 360U);
    EXPECT_EQ(worked.stand.saplings_standing(), 360U) << "what is planted is not felled in the same year";
    EXPECT_TRUE(worked.report.entries[2].found_nothing()) << "stumps and felled logs stay";

    const Worked both{"name,treatment,share,from_dbh_cm\nthick,target_diameter,,20\nthin,thin_below,1,\n"};
    EXPECT_EQ(both.report.entries[0].stems + both.report.entries[1].stems,
              static_cast<double>(both.before_trees));
    EXPECT_NEAR(both.report.timber.total().stems, static_cast<double>(both.before_trees), 1e-9);
}

TEST(Apply, TellsWhatWasDueAndFoundNothing) {
    const Worked worked{"treatment,from_dbh_cm\ntarget_diameter,150\n"};
    ASSERT_EQ(worked.report.entries.size(), 1U);
    EXPECT_TRUE(worked.report.entries[0].found_nothing());
    EXPECT_EQ(worked.report.entries[0].areas, 1U);
    EXPECT_EQ(worked.stand.trees().size(), worked.before_trees);
    EXPECT_TRUE(Worked("treatment,first_year\nclear_cut,5\n").report.entries.empty()) << "not due";
}

TEST(Apply, FencesItsAreasForAsLongAsTheTableSays) {
    const Worked worked{"treatment,where,stands,fence_years\nfence,stands,2,8\n"};
    EXPECT_NEAR(worked.report.entries[0].fenced_ha, 0.18, 1e-12);
    EXPECT_FALSE(worked.report.entries[0].found_nothing());
    for (std::uint32_t p = 0; p < worked.stand.grid().size(); ++p) {
        const bool is_in = worked.stand.grid()[forest::PatchId{p}].management_unit == 2;
        EXPECT_EQ(worked.stand.patch_states()[p].fenced_years, is_in ? 8 : 0);
    }
    EXPECT_EQ(worked.stand.trees().size(), worked.before_trees);
}

TEST(Apply, GivesTheSameBytesForAnyOrderOfTrees) {
    const std::string table =
        "name,treatment,share,from_dbh_cm,side_m,area_share,left_share,damage_share,where,stands,basal_area_"
        "m2pha\n"
        "loose,shelter_cut,0.3,,,,0.3,0.2,stands,1,\nsingle,selection,,,,,0.3,0.2,stands,2,15\n";
    std::vector<forest::Tree> trees = spruces(6);
    Worked straight{table};
    std::reverse(trees.begin(), trees.end());
    std::rotate(trees.begin(), trees.begin() + 41, trees.end());
    Worked permuted{table, forest::Stand{two_stands(6), species_table().size(), trees, 2000}};
    ASSERT_EQ(straight.stand.trees().size(), permuted.stand.trees().size());
    for (std::size_t i = 0; i < straight.stand.trees().size(); ++i) {
        EXPECT_EQ(straight.stand.trees()[i].id, permuted.stand.trees()[i].id);
    }
    EXPECT_EQ(straight.report.timber.total().taken_m3, permuted.report.timber.total().taken_m3);
    EXPECT_EQ(straight.report.timber.total().left_m3, permuted.report.timber.total().left_m3);
    EXPECT_EQ(straight.stand.wounds().size(), permuted.stand.wounds().size());
    EXPECT_EQ(straight.state, permuted.state);
}

TEST(Apply, GoesOnTheSameFromAStoredState) {
    const forest::SmallForest place{two_stands(6)};
    const Regime regime = regime_of(
        "name,treatment,first_year,every_years,after,after_years,from_age_years,where,entries,width_m,angle_"
        "deg,share\n"
        "open,shelter_cut,0,2,,,70,strips,3,20,0,0.4\nclear,clear_cut,,,open,1,,,,,,\n"
        "thin,thin_below,,,,,80,strips,,20,0,0.1\n",
        place.grid);
    const auto years = [&](forest::Stand& stand, RegimeState& state, int from, int to) {
        std::string told;
        for (int year = from; year < to; ++year) {
            static_cast<void>(place.grow(stand));
            for (const Entry& entry : apply(regime, year, stand, species_table(), state, {1, 0}).entries) {
                told +=
                    std::to_string(entry.year) + entry.intervention + std::to_string(entry.taken_m3) + ' ';
            }
        }
        return told;
    };
    forest::Stand whole{place.grid, species_table().size(), spruces(6), 2000};
    RegimeState state;
    const std::string first = years(whole, state, 0, 3);
    forest::Stand copy = whole;
    RegimeState restored;
    restored.visits = state.visits;
    restored.clearings = state.clearings;
    EXPECT_EQ(years(whole, state, 3, 7), years(copy, restored, 3, 7));
    EXPECT_EQ(state, restored);
    EXPECT_NE(first.find("0open"), std::string::npos) << first;
    EXPECT_NE(first.find("1clear"), std::string::npos) << first;
    RegimeState forgetful;
    forest::Stand again{place.grid, species_table().size(), spruces(6), 2000};
    years(again, forgetful, 0, 3);
    forgetful = {};
    EXPECT_EQ(years(again, forgetful, 3, 4).find("3clear"), std::string::npos) << "the state is needed";
}

TEST(ShippedRegimes, KeepTheBalanceAndDoWhatTheyAreNamedFor) {
    forest::SmallForest place{two_stands(12)};
    place.parameters.disturbance = {.storm_years = {2002.0}, .intensity_asked_for = 1.0};  // year 1
    for (const std::string& name : shipped_regime_names()) {
        SCOPED_TRACE(name);
        const bool leaves_all = name == "none" || name == "storm_left";
        const Regime regime = regime_of(std::string{shipped_regime(name)}, place.grid);
        forest::Stand stand{place.grid, species_table().size(), spruces(12), 2000};
        RegimeState state;
        double taken_m3 = 0.0;
        for (int year = 0; year < 3; ++year) {
            static_cast<void>(place.grow(stand));
            taken_m3 += apply(regime, year, stand, species_table(), state, {1, 0}).timber.total().taken_m3;
            EXPECT_TRUE(books_close(stand));
        }
        EXPECT_EQ(taken_m3 > 0.0, !leaves_all);
        if (name.starts_with("storm_")) {
            const std::span<const forest::Log> logs = stand.dead_wood().logs;
            EXPECT_EQ(std::any_of(logs.begin(), logs.end(),
                                  [](const forest::Log& log) {
                                      return log.origin == forest::LogOrigin::windthrow && log.year == 2002;
                                  }),
                      leaves_all);
            EXPECT_EQ(std::any_of(logs.begin(), logs.end(),
                                  [](const forest::Log& log) {
                                      return log.origin == forest::LogOrigin::felled_crosswise;
                                  }),
                      name == "storm_logs_left");
            EXPECT_EQ(std::any_of(stand.cohorts().begin(), stand.cohorts().end(),
                                  [](const forest::Cohort& young) { return young.guarded_years > 0; }),
                      name == "storm_cleared_planted");
        }
        const bool high_stumps = std::any_of(
            stand.dead_wood().snags.begin(), stand.dead_wood().snags.end(),
            [](const forest::Snag& snag) { return snag.cut && std::abs(snag.height_m - 1.3) < 1e-9; });
        EXPECT_EQ(high_stumps, name == "pfm1" || name == "pfm2");
    }
}

}  // namespace
}  // namespace coupling::apply_test
