#include "coupling/regimes/apply.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "coupling/regimes/shipped.hpp"
#include "forest/tables.hpp"
#include "tests/coupling/regimes/regime_forest.hpp"

namespace coupling::apply_test {
namespace {

/// A regime of one row at work in one year.
struct Worked {
    explicit Worked(const std::string& table, forest::Stand stand_in = spruce_stand(6), int year = 0)
        : before_m3{volume_m3(stand_in)}, before_trees{stand_in.trees().size()}, stand{std::move(stand_in)} {
        for (const forest::Tree& tree : stand.trees()) {
            patch_of[tree.id] = tree.patch;
        }
        report = apply(regime_of(table, stand.grid()), year, stand, species_table(), state, {1, 0});
    }

    /// What the report says of a cut is what the stand lost.
    void expect_cut_is_accounted_for() const {
        ASSERT_EQ(report.entries.size(), 1U);
        const Entry& entry = report.entries[0];
        EXPECT_FALSE(entry.found_nothing());
        EXPECT_NEAR(entry.taken_m3 + entry.left_m3, before_m3 - volume_m3(stand), 1e-6);
        EXPECT_EQ(entry.stems, static_cast<double>(before_trees - stand.trees().size()));
        EXPECT_EQ(entry.stems,
                  static_cast<double>(stand.balance().stems_out[forest::index_of(forest::Cause::felled)]));
        EXPECT_EQ(report.timber.total().taken_m3, entry.taken_m3);
        EXPECT_TRUE(books_close(stand));
        std::map<forest::TreeId, forest::PatchId> gone = patch_of;
        for (const forest::Tree& tree : stand.trees()) {
            gone.erase(tree.id);
        }
        std::set<forest::PatchId> patches;
        for (const auto& [tree, patch] : gone) {
            patches.insert(patch);
        }
        EXPECT_EQ(entry.cut_patches, (std::vector<forest::PatchId>{patches.begin(), patches.end()}))
            << "patches that lost a tree, rising";
    }

    std::map<forest::TreeId, forest::PatchId> patch_of;  ///< before the work
    double before_m3;
    std::size_t before_trees;
    forest::Stand stand;
    RegimeState state;
    RegimeReport report;
};

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
    const forest::SmallForest place{two_stands(12)};
    for (const std::string& name : shipped_regime_names()) {
        SCOPED_TRACE(name);
        const Regime regime = regime_of(std::string{shipped_regime(name)}, place.grid);
        forest::Stand stand{place.grid, species_table().size(), spruces(12), 2000};
        RegimeState state;
        double taken_m3 = 0.0;
        for (int year = 0; year < 3; ++year) {
            static_cast<void>(place.grow(stand));
            taken_m3 += apply(regime, year, stand, species_table(), state, {1, 0}).timber.total().taken_m3;
            EXPECT_TRUE(books_close(stand));
        }
        EXPECT_EQ(taken_m3 > 0.0, name != "none");
        const bool high_stumps = std::any_of(
            stand.dead_wood().snags.begin(), stand.dead_wood().snags.end(),
            [](const forest::Snag& snag) { return snag.cut && std::abs(snag.height_m - 1.3) < 1e-9; });
        EXPECT_EQ(high_stumps, name == "pfm1" || name == "pfm2");
    }
}

double basal_area_m2pha(const forest::Stand& stand) {
    double sum_m2 = 0.0;
    for (const forest::Tree& tree : stand.trees()) {
        sum_m2 += tree.stems * forest::basal_area_m2(tree.dbh_cm);
    }
    return sum_m2 / stand.grid().area_ha();
}

TEST(Apply, ThinsToABasalArea) {
    const Worked worked{"treatment,to_basal_area_m2pha\nthin_to_basal_area,20\n"};
    ASSERT_GT(basal_area_m2pha(spruce_stand(6)), 25.0);
    EXPECT_LE(basal_area_m2pha(worked.stand), 20.0);
    const double thickest_m2 = forest::basal_area_m2(50.0);
    EXPECT_GT(basal_area_m2pha(worked.stand), 20.0 - thickest_m2 / worked.stand.grid().area_ha())
        << "less than one tree below";
    EXPECT_FALSE(Worked{"treatment,to_basal_area_m2pha\nthin_to_basal_area,90\n"}.report.entries[0].stems >
                 0.0);
}

TEST(Apply, CutsTheSpeciesThatTheTableNames) {
    const auto mixed = [] {
        std::vector<forest::Tree> trees = spruces(6);
        for (std::size_t i = 0; i < trees.size(); i += 3) {
            trees[i].species = species_of("abal");
        }
        return forest::Stand{two_stands(6), species_table().size(), trees, 2000};
    };
    const auto count = [](const forest::Stand& stand, const char* code) {
        return std::count_if(stand.trees().begin(), stand.trees().end(),
                             [&](const forest::Tree& tree) { return tree.species == species_of(code); });
    };
    const auto firs = count(mixed(), "abal");
    const auto spruces_before = count(mixed(), "piab");
    ASSERT_GT(firs, 10);
    const Worked out{"treatment,only_species\nclear_cut,piab\n", mixed()};
    EXPECT_EQ(count(out.stand, "piab"), 0) << "a species out";
    EXPECT_EQ(count(out.stand, "abal"), firs);
    const Worked spared{"treatment,spare_species\nclear_cut,piab\n", mixed()};
    EXPECT_EQ(count(spared.stand, "piab"), spruces_before);
    EXPECT_EQ(count(spared.stand, "abal"), 0);
    // The basal area that stays is that of all species, though only spruce goes.
    const Worked one{"treatment,to_basal_area_m2pha,only_species\nthin_to_basal_area,25,piab\n", mixed()};
    EXPECT_EQ(count(one.stand, "abal"), firs);
    EXPECT_LE(basal_area_m2pha(one.stand), 25.0);
}

TEST(Apply, RetainsTheThickestTrees) {
    const Worked worked{"treatment,retain_pha\nclear_cut,50\n"};
    ASSERT_EQ(worked.stand.trees().size(), 18U) << "50 a hectare on 0.36 ha";
    std::vector<double> before;
    for (const forest::Tree& tree : spruce_stand(6).trees()) {
        before.push_back(tree.dbh_cm);
    }
    std::sort(before.rbegin(), before.rend());
    for (const forest::Tree& tree : worked.stand.trees()) {
        EXPECT_GE(tree.dbh_cm, before[17]);
    }
}

TEST(Apply, CutsCorridorsAlongLines) {
    const Worked worked{"treatment,where,lines,width_m\nclear_cut,corridors,lines.csv,10\n"};
    // The line runs from (20, 0) to (20, 28).
    const auto is_inside = [](const forest::Tree& tree) {
        return std::abs(tree.x_m - 20.0) < 5.0 && tree.y_m < 28.0;
    };
    std::size_t inside = 0;
    for (const forest::Tree& tree : spruce_stand(6).trees()) {
        inside += is_inside(tree) ? 1 : 0;
    }
    ASSERT_GT(inside, 10U);
    EXPECT_EQ(worked.report.entries[0].stems, static_cast<double>(inside));
    for (const forest::Tree& tree : worked.stand.trees()) {
        EXPECT_FALSE(is_inside(tree)) << tree.x_m << ' ' << tree.y_m;
    }
    EXPECT_NEAR(worked.report.entries[0].area_ha, 0.028, 0.004) << "10 x 28 m, by points 2 m apart";
}

TEST(Apply, ActsOnTheCutsOfAnotherRow) {
    const std::string regime =
        "name,treatment,first_year,every_years,side_m,area_share,where,after_years,fence_years,species,"
        "plants_pha,from_age_years,to_age_years,share\n"
        "groups,group_cut,0,10,20,0.15,,,,,,,,\n"
        "fences,fence,,,,,cuts_of:groups,,12,,,,,\n"
        "planting,plant,,,,,cuts_of:groups,1,,abal,2500,,,\n"
        "tending,tend,0,1,,,cuts_of:groups,,,abal,,5,7,0.5\n";
    forest::Stand stand = spruce_stand(10);
    RegimeState state;
    const Regime read = regime_of(regime, stand.grid());
    std::map<std::string, std::string> areas_by_year;
    double holes_ha = 0.0;
    for (int year = 0; year <= 12; ++year) {
        const RegimeReport report = apply(read, year, stand, species_table(), state, {1, 0});
        for (const Entry& entry : report.entries) {
            areas_by_year[entry.intervention] +=
                std::to_string(year) + ':' + std::to_string(entry.areas) + ' ';
            if (year == 0 && entry.intervention == "groups") {
                holes_ha = entry.area_ha;
            }
            if (year == 0 && entry.intervention == "fences") {
                EXPECT_NEAR(entry.area_ha, holes_ha, 1e-9) << "the holes alone, not the whole forest";
            }
            if (year == 1 && entry.intervention == "planting") {
                EXPECT_NEAR(entry.area_ha, holes_ha, 1e-9);
                EXPECT_NEAR(static_cast<double>(entry.plants), 2500.0 * holes_ha,
                            4.0 * std::sqrt(2500.0 * holes_ha));
            }
        }
    }
    ASSERT_NEAR(holes_ha, 0.12, 1e-9) << "three holes of 20 m on a hectare";
    const auto areas = [&](const char* row, const std::string& wanted) {
        EXPECT_TRUE(areas_by_year[row].starts_with(wanted)) << row << ": " << areas_by_year[row];
    };
    areas("groups", "0:1 10:1 ");
    areas("fences", "0:3 10:");
    areas("planting", "1:3 11:");
    areas("tending", "5:3 6:3 ");
}

TEST(Apply, FollowsAGroupCutIntoItsHoles) {
    const std::string regime =
        "name,treatment,side_m,area_share,after,after_years,species,plants_pha\n"
        "groups,group_cut,20,0.15,,,,\nplanting,plant,,,groups,0,abal,2500\n";
    const Worked worked{regime, spruce_stand(10)};
    ASSERT_EQ(worked.report.entries.size(), 2U) << "in the same year";
    EXPECT_NEAR(worked.report.entries[1].area_ha, worked.report.entries[0].area_ha, 1e-9);
    EXPECT_GT(worked.report.entries[1].plants, 0U);
}

TEST(Apply, KeepsToASteepness) {
    // The slope has 30 degrees everywhere.
    EXPECT_GT(Worked{"treatment,to_slope_deg\nclear_cut,40\n"}.report.entries[0].stems, 0.0);
    EXPECT_NE(problems_of("treatment,to_slope_deg\nclear_cut,25\n", two_stands(6)).find("meets no forest"),
              std::string::npos);
}

TEST(Apply, WorksInTheOrderThatTheUserGives) {
    // Trees from 40 cm first, then the rest thinned to a basal area: it finds what the first has left.
    const std::string table =
        "name,treatment,order,from_dbh_cm,to_basal_area_m2pha\n"
        "rest,thin_to_basal_area,2,,10\nthick,target_diameter,1,40,\n";
    Worked worked{table};
    ASSERT_EQ(worked.report.entries.size(), 2U);
    EXPECT_EQ(worked.report.entries[0].intervention, "thick");
    EXPECT_EQ(worked.report.entries[1].intervention, "rest");
    EXPECT_GT(worked.report.entries[1].stems, 0.0);
    double basal_area_m2 = 0.0;
    for (const forest::Tree& tree : worked.stand.trees()) {
        EXPECT_LT(tree.dbh_cm, 40.0);
        basal_area_m2 += forest::basal_area_m2(tree.dbh_cm);
    }
    EXPECT_LE(basal_area_m2 / worked.stand.grid().area_ha(), 10.0);
    EXPECT_TRUE(books_close(worked.stand));
}

TEST(Apply, GuardsEachPlantForItsYears) {
    Worked worked{"treatment,species,plants_pha,guard_years\nplant,abal,1000,8\n"};
    EXPECT_EQ(worked.report.entries[0].guarded, worked.report.entries[0].plants);
    for (const forest::Cohort& cohort : worked.stand.cohorts()) {
        EXPECT_EQ(cohort.guarded_years, 8U);
    }
    std::vector<forest::CohortGrowth> growth(worked.stand.cohorts().size());
    for (forest::CohortGrowth& one : growth) {
        one.height_m = 0.4;
    }
    worked.stand.grow_cohorts(growth);
    EXPECT_EQ(worked.stand.cohorts().front().guarded_years, 7U);
}

}  // namespace
}  // namespace coupling::apply_test
