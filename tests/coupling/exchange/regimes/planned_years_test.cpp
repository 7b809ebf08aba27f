#include "coupling/exchange/regimes/planned_years.hpp"

#include <gtest/gtest.h>

#include "tests/coupling/exchange/regimes/regime_forest.hpp"

namespace coupling::planned_years_test {
namespace {

using Years = std::vector<int>;

TEST(PlannedYears, AreThoseOfTheCalendarByTurn) {
    const Regime regime = regime_of(
        "name,treatment,first_year,every_years,last_year,where,entries,width_m,angle_deg,after,after_years,"
        "species,plants_pha\n"
        "cut,clear_cut,2,5,25,strips,3,20,0,,,,\n"
        "planting,plant,,,,,,,,cut,3,abal,2000\n"
        "second,plant,,,20,,,,,planting,1,acps,500\n",
        two_stands(10));
    EXPECT_EQ(planned_years(regime, 0, 0, 30).years, (Years{2, 17}));
    EXPECT_EQ(planned_years(regime, 0, 1, 30).years, (Years{7, 22}));
    EXPECT_EQ(planned_years(regime, 0, std::nullopt, 30).years, (Years{2, 7, 12, 17, 22}));
    EXPECT_EQ(planned_years(regime, 0, 1, 20).years, (Years{7})) << "the run is over";
    EXPECT_EQ(planned_years(regime, 1, 0, 30).years, (Years{5, 20}));
    EXPECT_EQ(planned_years(regime, 2, 0, 30).years, (Years{6})) << "21 comes after its last year";
    EXPECT_TRUE(planned_years(regime, 2, 0, 30).condition.empty());
}

TEST(PlannedYears, AgreeWithTheTurnOfEachYear) {
    const Regime regime = regime_of(
        "name,treatment,first_year,every_years,where,entries,width_m,angle_deg\n"
        "cut,clear_cut,1,4,strips,5,20,0\n",
        two_stands(10));
    for (int turn = 0; turn < 5; ++turn) {
        Years wanted;
        for (int year = 0; year <= 60; ++year) {
            if (turn_of(regime.interventions()[0], year) == turn) {
                wanted.push_back(year);
            }
        }
        EXPECT_FALSE(wanted.empty());
        EXPECT_EQ(planned_years(regime, 0, turn, 60).years, wanted);
    }
}

TEST(PlannedYears, SayWhatDecidesBesideTheCalendar) {
    const Regime regime = regime_of(
        "name,treatment,first_year,every_years,from_age_years,to_gap_m,from_damage_m3pha,share,where,after,"
        "after_years,species,plants_pha\n"
        "thinning,thin_below,3,,60,25,,0.2,,,,,\n"
        "opening,shelter_cut,5,10,40,,,0.3,,,,,\n"
        "clearance,clear_cut,,,,,,,,opening,5,,\n"
        "salvage,salvage,1,1,,,,0.8,,,,,\n"
        "planting,plant,,,,,,,cuts_of:salvage,,1,abal,2000\n",
        two_stands(6));
    const PlannedYears thinning = planned_years(regime, 0, 0, 10);
    EXPECT_EQ(thinning.condition, "from_age_years = 60, to_gap_m = 25");
    EXPECT_TRUE(thinning.once);
    EXPECT_EQ(thinning.years.front(), 3);
    EXPECT_EQ(thinning.years.back(), 10);
    const PlannedYears opening = planned_years(regime, 1, 0, 30);
    EXPECT_EQ(opening.years, (Years{5, 15, 25}));
    EXPECT_FALSE(opening.once);
    EXPECT_EQ(opening.condition, "from_age_years = 40");
    const PlannedYears clearance = planned_years(regime, 2, 0, 30);
    EXPECT_EQ(clearance.after, 1U) << "when the opening comes is not known";
    EXPECT_TRUE(clearance.years.empty());
    EXPECT_EQ(planned_years(regime, 3, 0, 3).years, (Years{1, 2, 3}));
    EXPECT_EQ(planned_years(regime, 4, std::nullopt, 30).after, 3U) << "it finds wood or not";
}

TEST(PlannedYears, OfRowsOnTheCutsOfAnotherAreThoseOfItsCalendar) {
    const Regime regime = regime_of(
        "name,treatment,first_year,every_years,side_m,area_share,where,after_years,species,plants_pha,share\n"
        "groups,group_cut,0,10,20,0.1,,,,,\n"
        "planting,plant,,,,,cuts_of:groups,1,abal,2000,\n"
        "tending,tend,4,6,,,cuts_of:groups,,abal,,0.5\n",
        two_stands(10));
    EXPECT_EQ(planned_years(regime, 1, std::nullopt, 25).years, (Years{1, 11, 21}));
    EXPECT_EQ(planned_years(regime, 2, std::nullopt, 25).years, (Years{4, 10, 16, 22}));
}

}  // namespace
}  // namespace coupling::planned_years_test
