#include "forest/stand/site_height.hpp"

#include <gtest/gtest.h>

namespace forest::site_height_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();

TEST(SiteHeight, FallsFromTheGreatestHeightTowardsTheTimberLine) {
    // 500 m, 1000 m, 1500 m and 2000 m of the Kalkalpen gradient.
    const HeightGrowth& spruce = table[*table.find("piab")].height_growth;
    const double shares[] = {site_height_m(spruce, 1929.0), site_height_m(spruce, 1323.0),
                             site_height_m(spruce, 815.0), site_height_m(spruce, 428.0)};
    EXPECT_NEAR(shares[0] / spruce.max_height_m, 0.968, 0.001);
    EXPECT_NEAR(shares[1] / spruce.max_height_m, 0.906, 0.001);
    EXPECT_NEAR(shares[2] / spruce.max_height_m, 0.767, 0.001);
    EXPECT_NEAR(shares[3] / spruce.max_height_m, 0.534, 0.001);
    EXPECT_DOUBLE_EQ(site_height_m(spruce, 0.0), 0.0);
}

TEST(HeightRoom, EndsHeightGrowthAtThePlacesGreatestHeight) {
    EXPECT_DOUBLE_EQ(height_room(0.0, 40.0), 1.0);
    EXPECT_DOUBLE_EQ(height_room(20.0, 40.0), 1.0 - 0.0625);
    EXPECT_DOUBLE_EQ(height_room(40.0, 40.0), 0.0);
    EXPECT_DOUBLE_EQ(height_room(60.0, 40.0), 0.0);
    EXPECT_DOUBLE_EQ(height_room(5.0, 0.0), 0.0) << "a place too cold for any tree";
}

TEST(UsualWarmth, IsTheMeanOfFewYearsAndFollowsAWarmerClimateWithinDecades) {
    UsualWarmth usual;
    usual = after_year(usual, 1000.0);
    EXPECT_DOUBLE_EQ(usual.degree_days, 1000.0);
    usual = after_year(usual, 1200.0);
    EXPECT_DOUBLE_EQ(usual.degree_days, 1100.0);
    for (int year = 0; year < 100; ++year) {
        usual = after_year(usual, 1500.0);
    }
    EXPECT_NEAR(usual.degree_days, 1500.0, 20.0);
    const double before = usual.degree_days;
    usual = after_year(usual, 500.0);
    EXPECT_GT(usual.degree_days, before - 40.0) << "one cold year does not make the place cold";
}

}  // namespace
}  // namespace forest::site_height_test
