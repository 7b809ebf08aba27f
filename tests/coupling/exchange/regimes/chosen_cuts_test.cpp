// Which trees, species, ground and order a row of a regime names.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "forest/inventory/tables.hpp"
#include "tests/coupling/exchange/regimes/worked.hpp"

namespace coupling::chosen_cuts_test {
namespace {

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
    const forest::Stand untouched = spruce_stand(6);
    for (const forest::Tree& tree : untouched.trees()) {
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
    const forest::Stand untouched = spruce_stand(6);
    for (const forest::Tree& tree : untouched.trees()) {
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
}  // namespace coupling::chosen_cuts_test
