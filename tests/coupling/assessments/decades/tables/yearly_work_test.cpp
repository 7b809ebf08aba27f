#include "coupling/assessments/decades/tables/yearly_work.hpp"

#include <gtest/gtest.h>

#include "coupling/assessments/decades/members/record_work.hpp"
#include "tests/coupling/exchange/regimes/regime_forest.hpp"

namespace coupling::decades::yearly_work_test {
namespace {

PriceTable prices() {
    return read_prices(
        table_of("species,dbh_from_cm,dbh_to_cm,sold_share,revenue_eur_per_m3,felling_eur_per_m3,"
                 "hauling_eur_per_m3\nany,0,,0.5,100,10,20\n"),
        table_of("work,cost_eur\nplanted_tree,2\ntended_ha,500\nfenced_ha,3000\n"), species_table());
}

TEST(WorkByYear, CountsWoodHoursAndSetupsByHand) {
    const forest::PatchGrid grid = two_stands(10);
    const Regime regime = regime_of(
        "name,treatment,first_year,where,lines,width_m,share\n"
        "lines,clear_cut,1,corridors,lines.csv,12,\n"
        "storm wood,salvage,1,,,,0.8\n",
        grid);
    RegimeReport report;
    report.timber.by_species.resize(species_table().size());
    report.timber.by_species[forest::index_of(species_of("piab"))][forest::dbh_class_of(30.0)] = {
        .stems = 9, .taken_m3 = 16.0, .left_m3 = 4.0};
    report.entries.push_back({.year = 1,
                              .intervention = "lines",
                              .treatment = Treatment::clear_cut,
                              .areas = 3,
                              .stems = 6,
                              .taken_m3 = 12.0,
                              .left_m3 = 3.0});
    report.entries.push_back({.year = 1,
                              .intervention = "storm wood",
                              .treatment = Treatment::salvage,
                              .areas = 1,
                              .stems = 3,
                              .taken_m3 = 4.0,
                              .left_m3 = 1.0});
    MemberYears member;
    member.member = {0, 0};
    member.years.resize(3);
    record_work(report, regime, prices(), 8.0, 1, member);
    // A year in which the corridors came due and nothing was taken sets no crane up.
    RegimeReport nothing;
    nothing.timber.by_species.resize(species_table().size());
    nothing.entries.push_back(
        {.year = 2, .intervention = "lines", .treatment = Treatment::clear_cut, .areas = 3});
    record_work(nothing, regime, prices(), 8.0, 2, member);

    const std::vector<std::string> regimes{"own"};
    const Names names{regimes, {{{"lines", "clear_cut"}, {"storm wood", "salvage"}}}, species_table()};
    constexpr double area_ha = 0.5;
    const std::vector<YearlyWork> years = work_by_year(names, member, area_ha);
    ASSERT_EQ(years.size(), 3U);
    EXPECT_EQ(years[0].machine_hours_pha, 0.0);
    EXPECT_NEAR(years[1].felled_m3pha, (12.0 + 3.0) / area_ha, 1e-12);
    EXPECT_NEAR(years[1].salvaged_m3pha, (4.0 + 1.0) / area_ha, 1e-12);
    EXPECT_NEAR(years[1].removed_m3pha, 16.0 / area_ha, 1e-12);
    EXPECT_NEAR(years[1].left_m3pha, 4.0 / area_ha, 1e-12);
    EXPECT_NEAR(years[1].machine_hours_pha, 16.0 / 8.0 / area_ha, 1e-12) << "only what is brought out";
    EXPECT_EQ(years[1].cable_setups, 3.0) << "corridors, in the whole forest";
    EXPECT_NEAR(years[1].revenue_eur_pha, 16.0 * 0.5 * 100.0 / area_ha, 1e-9);
    EXPECT_NEAR(years[1].harvest_cost_eur_pha, (20.0 * 10.0 + 16.0 * 20.0) / area_ha, 1e-9);
    EXPECT_EQ(years[2].machine_hours_pha, 0.0);
    EXPECT_EQ(years[2].cable_setups, 0.0);
}

}  // namespace
}  // namespace coupling::decades::yearly_work_test
