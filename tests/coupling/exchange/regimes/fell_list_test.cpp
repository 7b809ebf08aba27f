#include "coupling/exchange/regimes/fell_list.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <sstream>

#include "tests/coupling/exchange/regimes/regime_forest.hpp"

namespace coupling::fell_list_test {
namespace {

config::Table list_of(const std::string& rows) {
    std::istringstream in{"tree_id,year\n" + rows};
    return config::Table::read(in, "felled.csv");
}

Regime replayed(const std::string& rows, const RunYears& run = {}) {
    return Regime::read(table_of("treatment,trees\nfell_list,felled.csv\n"), "recorded", species_table(),
                        two_stands(6), one_polygon, run,
                        [&](const std::string&, const std::string&) { return list_of(rows); });
}

TEST(FellList, IsReadByYearAndNumber) {
    const std::vector<ListedTree> list = read_fell_list(list_of("7,2\n3,1\n1,2\n"));
    EXPECT_EQ(list, (std::vector<ListedTree>{{3, 1}, {1, 2}, {7, 2}}));
}

TEST(FellList, FellsTheTreesOfEachYearAndNoOthers) {
    const Regime regime = replayed("0,0\n5,0\n9,3\n10,3\n200,3\n");
    forest::Stand stand = spruce_stand(6);
    RegimeState state;
    const std::size_t before = stand.trees().size();
    std::vector<double> felled;
    for (int year = 0; year <= 4; ++year) {
        const RegimeReport report = apply(regime, year, stand, species_table(), state, {1, 0});
        felled.push_back(report.timber.by_species.empty() ? 0.0 : report.timber.total().stems);
    }
    EXPECT_EQ(felled, (std::vector<double>{2.0, 0.0, 0.0, 3.0, 0.0}));
    EXPECT_EQ(stand.trees().size(), before - 5);
    for (const std::uint64_t number : {0U, 5U, 9U, 10U, 200U}) {
        EXPECT_FALSE(stand.find(forest::TreeId{number})) << number;
    }
    EXPECT_EQ(stand.dead_wood().snags.size(), 5U) << "their stumps";
}

TEST(FellList, PassesOverTreesThatHaveDied) {
    const Regime regime = replayed("0,1\n5,1\n");
    forest::Stand stand = spruce_stand(6);
    stand.remove_trees(std::vector<forest::Removal>{{forest::TreeId{5}, forest::Cause::stress}});
    RegimeState state;
    const RegimeReport report = apply(regime, 1, stand, species_table(), state, {1, 0});
    ASSERT_EQ(report.entries.size(), 1U);
    EXPECT_EQ(report.entries[0].stems, 1.0);
}

TEST(FellList, CountsCalendarYearsFromTheStartOfTheRun) {
    const Regime regime = replayed("0,2010\n5,2012\n9,2050\n", {2010, 20});
    EXPECT_EQ(turn_of(regime.interventions()[0], 0), 0);
    EXPECT_EQ(turn_of(regime.interventions()[0], 1), std::nullopt);
    EXPECT_EQ(turn_of(regime.interventions()[0], 2), 0);
    EXPECT_THROW(replayed("0,2009\n", {2010, 20}), config::InputError) << "before the run";
    EXPECT_THROW(replayed("0,2031\n", {2010, 20}), config::InputError) << "none of it in the run";
    EXPECT_THROW(replayed("0,2012\n"), config::InputError) << "a run that knows no calendar";
}

TEST(FellList, IsFollowedOnThePatchesOfItsTreesAlone) {
    const Regime regime =
        Regime::read(table_of("name,treatment,trees,where,after_years,species,plants_pha\n"
                              "list,fell_list,felled.csv,,,,\nplanting,plant,,cuts_of:list,1,abal,2500\n"),
                     "recorded", species_table(), two_stands(6), one_polygon, {},
                     [](const std::string&, const std::string&) { return list_of("0,2\n1,2\n"); });
    forest::Stand stand = spruce_stand(6);
    RegimeState state;
    std::set<forest::PatchId> patches;
    for (const std::uint64_t number : {0U, 1U}) {
        patches.insert(stand.trees()[*stand.find(forest::TreeId{number})].patch);
    }
    double planted_ha = 0.0;
    for (int year = 0; year <= 6; ++year) {
        for (const Entry& entry : apply(regime, year, stand, species_table(), state, {1, 0}).entries) {
            if (entry.intervention == "planting") {
                EXPECT_EQ(year, 3);
                planted_ha += entry.area_ha;
                EXPECT_NEAR(static_cast<double>(entry.plants), 2500.0 * entry.area_ha,
                            4.0 * std::sqrt(2500.0 * entry.area_ha));
            }
        }
    }
    EXPECT_NEAR(planted_ha, 0.01 * static_cast<double>(patches.size()), 1e-9);
    for (const forest::Cohort& cohort : stand.cohorts()) {
        EXPECT_TRUE(patches.contains(cohort.patch));
    }
    EXPECT_FALSE(stand.cohorts().empty());
}

TEST(FellList, GoesWithOtherCutsOfItsYear) {
    const Regime regime =
        Regime::read(table_of("treatment,trees,share,every_years,name\nfell_list,felled.csv,,,list\n"
                              "thin_below,,0.2,1,thinning\n"),
                     "recorded", species_table(), two_stands(6), one_polygon, {},
                     [](const std::string&, const std::string&) { return list_of("0,0\n"); });
    forest::Stand stand = spruce_stand(6);
    RegimeState state;
    const RegimeReport report = apply(regime, 0, stand, species_table(), state, {1, 0});
    ASSERT_EQ(report.entries.size(), 2U);
    EXPECT_EQ(report.entries[0].stems, 1.0);
    EXPECT_GT(report.entries[1].stems, 0.0);
}

}  // namespace
}  // namespace coupling::fell_list_test
