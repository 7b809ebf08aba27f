#include "coupling/exchange/regimes/due.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "forest/inventory/tables.hpp"
#include "forest/treatment/selection.hpp"
#include "tests/coupling/exchange/regimes/regime_forest.hpp"

namespace coupling::due_test {
namespace {

/// Years of a list in which a row comes to an area, on a stand that does not change.
std::string years_of(const Regime& regime, std::size_t intervention, std::size_t area,
                     const forest::Stand& stand, int last_year) {
    RegimeState state;
    std::string years;
    for (int year = 0; year <= last_year; ++year) {
        const std::vector<Due> due = due_in(regime, year, stand, species_table(), state);
        for (const Due& row : due) {
            if (row.intervention == intervention &&
                std::find(row.areas.begin(), row.areas.end(), area) != row.areas.end()) {
                years += std::to_string(year) + ' ';
            }
        }
        remember(regime, year, due, state);
    }
    return years;
}

TEST(DueIn, TakesEntriesInTurn) {
    const forest::Stand stand = spruce_stand(6);
    const Regime regime = regime_of(
        "treatment,first_year,every_years,last_year,where,entries,width_m,angle_deg\n"
        "clear_cut,5,10,50,strips,3,20,0\n",
        stand.grid());
    ASSERT_EQ(regime.areas_of(0).size(), 4U) << "strips begin half a patch outside";
    EXPECT_EQ(years_of(regime, 0, 0, stand, 80), "5 35 ");
    EXPECT_EQ(years_of(regime, 0, 1, stand, 80), "15 45 ");
    EXPECT_EQ(years_of(regime, 0, 3, stand, 80), "5 35 ");
}

TEST(DueIn, FollowsAnotherRowAreaByArea) {
    const forest::Stand stand = spruce_stand(6);
    const Regime regime = regime_of(
        "name,treatment,first_year,every_years,last_year,after,after_years,where,entries,width_m,angle_deg,"
        "share\n"
        "open,shelter_cut,0,10,30,,,strips,3,20,0,0.3\nclear,clear_cut,,,,open,8,,,,,\n",
        stand.grid());
    EXPECT_EQ(years_of(regime, 1, 0, stand, 60), "8 38 ");
    EXPECT_EQ(years_of(regime, 1, 2, stand, 60), "28 ");
}

TEST(DueIn, WaitsForAgeAndComesOnceUntilTheAreaIsCleared) {
    const forest::Stand stand = spruce_stand(4);  // 80 years old for ever, until it is cleared
    const std::string head = "name,treatment,first_year,every_years,from_age_years,to_age_years,share\n";
    const auto years = [&](const std::string& rows) {
        return years_of(regime_of(head + rows, stand.grid()), 0, 0, stand, 99);
    };
    EXPECT_EQ(years("a,thin_below,0,,75,85,0.2\n"), "0 ");
    EXPECT_EQ(years("a,thin_below,0,,85,,0.2\n"), "");
    EXPECT_EQ(years("a,thin_below,0,,,80,0.2\n"), "") << "younger than";
    EXPECT_EQ(years("a,thin_below,0,40,75,,0.2\n"), "0 40 80 ") << "a calendar repeats";
    // Cleared in year 20: age counts from there.
    EXPECT_EQ(years("a,thin_below,0,,30,45,0.2\nb,clear_cut,20,,,,\n"), "50 ");
    EXPECT_EQ(years("a,thin_below,0,,30,85,0.2\nb,clear_cut,20,,,,\n"), "0 50 ");
    EXPECT_EQ(years("a,clear_cut,0,,30,,\n"), "0 30 60 90 ");
}

TEST(DueIn, WaitsForHeightBasalAreaAndDensity) {
    const forest::Stand stand = spruce_stand(4);
    const auto due = [&](const std::string& condition, double value) {
        const Regime regime =
            regime_of("treatment,share," + condition + "\nthin_below,0.2," + std::to_string(value) + '\n',
                      stand.grid());
        return !due_in(regime, 0, stand, species_table(), {}).empty();
    };
    std::vector<std::size_t> all(stand.trees().size());
    std::iota(all.begin(), all.end(), 0);
    const forest::StandFigures figures = forest::figures_of(stand.trees(), species_table(), 0.16);
    const double density = forest::relative_density(stand, species_table(), all, 0.16);
    for (const auto& [condition, value] : {std::pair{"from_dominant_height_m", figures.dominant_height_m},
                                           std::pair{"from_basal_area_m2pha", figures.basal_area_m2pha},
                                           std::pair{"from_relative_density", density}}) {
        EXPECT_TRUE(due(condition, 0.99 * value)) << condition;
        EXPECT_FALSE(due(condition, 1.01 * value)) << condition;
    }
}

TEST(AgeOf, IsThatOfTheThickestHundredPerHectare) {
    std::vector<forest::Tree> trees = spruces(4);  // 100 trees on 0.16 ha: 16 count
    for (forest::Tree& tree : trees) {
        tree.age_years = tree.dbh_cm >= 40.0 ? 120.0 : 30.0;
    }
    const forest::Stand stand{two_stands(4), species_table().size(), trees, 2000};
    std::vector<std::size_t> all(trees.size());
    std::iota(all.begin(), all.end(), 0);
    EXPECT_NEAR(age_of(stand, all, 0.16, std::nullopt), 120.0, 1e-9);
    EXPECT_NEAR(age_of(stand, all, 0.16, 7), 7.0, 1e-9);
    EXPECT_EQ(age_of(stand, {}, 0.16, std::nullopt), 0.0);
}

TEST(DueIn, WaitsForDamageOfTheYear) {
    const auto due = [](const forest::Stand& stand, double damage_m3pha) {
        const Regime regime = regime_of("treatment,every_years,share,from_damage_m3pha\nsalvage,1,0.8," +
                                            std::to_string(damage_m3pha) + '\n',
                                        stand.grid());
        return !due_in(regime, 3, stand, species_table(), {}).empty();
    };
    forest::Stand stand = spruce_stand(4);
    EXPECT_FALSE(due(stand, 1.0)) << "nothing has fallen";
    const double before_m3 = volume_m3(stand);
    std::vector<forest::Removal> removals;
    for (std::size_t i = 0; i < 10; ++i) {
        removals.push_back({stand.trees()[i].id, forest::Cause::wind});
    }
    removals.push_back({stand.trees()[20].id, forest::Cause::self_thinning});
    const forest::Tree& crowded = stand.trees()[20];
    const double crowded_m3 =
        forest::stem_volume_m3(species_table()[crowded.species].allometry, crowded.dbh_cm, crowded.height_m);
    stand.remove_trees(removals);
    const double thrown_m3pha = (before_m3 - volume_m3(stand) - crowded_m3) / stand.grid().area_ha();
    EXPECT_TRUE(due(stand, thrown_m3pha - 0.01)) << "what stood too close does not count";
    EXPECT_FALSE(due(stand, thrown_m3pha + 0.01));
}

TEST(DueIn, WaitsForTheLengthOfAGap) {
    forest::Stand stand = spruce_stand(6);
    const auto due = [&](const std::string& column, double gap_m) {
        const Regime regime = regime_of(
            "treatment,share," + column + "\nthin_below,0.2," + std::to_string(gap_m) + '\n', stand.grid());
        return !due_in(regime, 0, stand, species_table(), {}).empty();
    };
    EXPECT_TRUE(due("to_gap_m", 5.0)) << "the stand is closed";
    EXPECT_FALSE(due("from_gap_m", 5.0));
    std::vector<forest::Removal> removals;
    for (const forest::Tree& tree : stand.trees()) {
        if (tree.x_m < 10.0 && tree.y_m < 40.0) {
            removals.push_back({tree.id, forest::Cause::felled});
        }
    }
    stand.remove_trees(removals);
    // Four patches down a slope of 30 degrees.
    const double length_m = 40.0 / std::cos(30.0 * M_PI / 180.0);
    EXPECT_TRUE(due("from_gap_m", length_m - 1.0));
    EXPECT_FALSE(due("from_gap_m", length_m + 1.0));
    EXPECT_FALSE(due("to_gap_m", length_m - 1.0));
    EXPECT_TRUE(due("to_gap_m", length_m + 1.0));
}

}  // namespace
}  // namespace coupling::due_test
