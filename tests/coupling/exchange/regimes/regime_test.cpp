#include "coupling/exchange/regimes/regime.hpp"

#include <gtest/gtest.h>

#include "coupling/exchange/regimes/shipped.hpp"
#include "tests/coupling/exchange/regimes/regime_forest.hpp"
#include "tests/coupling/parts_of_text.hpp"

namespace coupling::regime_test {
namespace {

using text_checks::has;

TEST(TurnOf, FollowsFirstEveryAndLastYear) {
    Intervention row;
    row.first_year = 3;
    EXPECT_FALSE(turn_of(row, 2));
    EXPECT_EQ(turn_of(row, 3), 0);
    EXPECT_FALSE(turn_of(row, 4)) << "without every_years once";
    row.every_years = 10;
    row.last_year = 33;
    row.ground.entries = 3;
    std::string seen;
    for (int year = 0; year < 60; ++year) {
        if (const auto turn = turn_of(row, year)) {
            seen += std::to_string(year) + ':' + std::to_string(*turn) + ' ';
        }
    }
    EXPECT_EQ(seen, "3:0 13:1 23:2 33:0 ");
}

TEST(Regime, LaysAllThatShareAGroundOnTheSameAreas) {
    const Regime regime = regime_of(
        "name,treatment,first_year,every_years,from_age_years,where,entries,width_m,angle_deg,share\n"
        "thinning,thin_below,,,40,strips,,20,0,0.2\n"
        "cut,clear_cut,0,10,,strips,5,20,0,\n"
        "wider,clear_cut,5,10,,strips,5,25,0,\n",
        two_stands(10));
    EXPECT_EQ(regime.ground_of(0), regime.ground_of(1));
    EXPECT_NE(regime.ground_of(0), regime.ground_of(2));
    double sum_ha = 0.0;
    for (const Area& area : regime.areas_of(0)) {
        sum_ha += area.area_ha;
    }
    EXPECT_NEAR(sum_ha, 1.0, 1e-9) << "strips cover the forest once";
}

TEST(Regime, KnowsStandsAndPolygons) {
    const Regime regime = regime_of(
        "name,treatment,first_year,where,stands,polygons\n"
        "each,clear_cut,0,stands,,\n"
        "second,clear_cut,1,stands,2,\n"
        "corner,clear_cut,2,polygons,,areas.csv\n"
        "part,clear_cut,3,polygons,1,areas.csv\n",
        two_stands(4));
    ASSERT_EQ(regime.areas_of(0).size(), 2U);
    EXPECT_EQ(regime.areas_of(0)[1].number, 2U);
    ASSERT_EQ(regime.areas_of(1).size(), 1U);
    EXPECT_NEAR(regime.areas_of(1)[0].area_ha, 0.08, 1e-9);
    EXPECT_NEAR(regime.areas_of(2)[0].area_ha, 0.04, 1e-9);
    EXPECT_EQ(regime.areas_of(2)[0].patches.size(), 4U);
}

TEST(ShapesIn, AreThoseOfTheColumnWkt) {
    const auto polygons = shapes_in(
        table_of("name,wkt\na,\"POLYGON ((0 0, 20 0, 20 20, 0 0))\"\nb,\"POLYGON ((5 5, 9 5, 9 9, 5 5))\"\n"),
        config::Shape::Kind::polygon);
    ASSERT_EQ(polygons.size(), 2U);
    EXPECT_EQ(polygons[1].parts[0][0].x_m, 5.0);
    EXPECT_THROW(shapes_in(table_of("name,wkt\na,POINT (1 1)\n"), config::Shape::Kind::polygon),
                 config::InputError);
    EXPECT_THROW(shapes_in(table_of("name,shape\na,b\n"), config::Shape::Kind::line), config::InputError);
}

TEST(Regime, LetsTreatmentsMeetOnOneGroundInAStatedOrder) {
    const forest::PatchGrid grid = two_stands(6);
    const std::string head = "treatment,order,where,lines,width_m,basal_area_m2pha,max_dbh_cm\n";
    const std::string corridors = "clear_cut,1,corridors,lines.csv,12,,\n";
    EXPECT_EQ(problems_of(head + corridors + "selection,2,,,,25,50\n", grid), "");
    for (const char* order : {"", "1"}) {
        const std::string text = problems_of(head + corridors + "selection," + order + ",,,,25,50\n", grid);
        EXPECT_TRUE(has(text, "on the same ground in year 0")) << text;
        EXPECT_TRUE(has(text, "numbers in `order`")) << text;
    }
    EXPECT_TRUE(has(problems_of(head + "clear_cut,0,,,,,\n", grid), "order"));
}

TEST(ShippedRegimes, AreValidOnALargeSlope) {
    const forest::PatchGrid grid = two_stands(40);
    EXPECT_EQ(shipped_regime_names(),
              (std::vector<std::string>{"bau_shelterwood", "none", "pfm1", "pfm2", "single_tree_selection",
                                        "storm_cleared", "storm_cleared_planted", "storm_left",
                                        "storm_logs_left"}));
    for (const std::string& name : shipped_regime_names()) {
        EXPECT_EQ(problems_of(std::string{shipped_regime(name)}, grid), "") << name;
    }
    EXPECT_TRUE(shipped_regime("gold").empty());
}

TEST(ShippedRegimes, OpenTheShareOfTheGroundTheySayInEachEntry) {
    const forest::PatchGrid grid = two_stands(60);
    for (const auto& [name, entries] : {std::pair{"pfm1", 8}, std::pair{"pfm2", 11}}) {
        const Regime regime = regime_of(std::string{shipped_regime(name)}, grid);
        ASSERT_EQ(regime.interventions()[0].ground.entries, entries);
        std::vector<double> share(static_cast<std::size_t>(entries), 0.0);
        for (const Area& area : regime.areas_of(0)) {
            share[static_cast<std::size_t>(area.order)] += area.area_ha / grid.area_ha();
        }
        for (const double one : share) {
            EXPECT_NEAR(one, 1.0 / entries, 0.03) << name;
        }
    }
}

}  // namespace
}  // namespace coupling::regime_test
