#include "forest/disturbance/wet_snow.hpp"

#include <gtest/gtest.h>

#include "tests/forest/small_forest.hpp"

namespace forest::wet_snow_test {
namespace {

ClimateYear year_at(double kelvin) {
    ClimateYear year = montane_year();
    for (ClimateMonth& month : year.months) {
        month.tave_degc += kelvin;
    }
    return year;
}

TEST(WetSnow, IsTheShareOfDaysNearZeroOfTheWinterRain) {
    ClimateYear year;
    for (ClimateMonth& month : year.months) {
        month.tave_degc = 0.5;
        month.prec_mm = 100.0;
    }
    // A degree either way of the mean, a third of the deviation: 0.2611 of the days of three months.
    EXPECT_NEAR(wet_snow_mm(year), 300.0 * 0.26112, 0.01);
    for (const std::size_t summer : {2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, 10U}) {
        year.months[summer].prec_mm = 0.0;
    }
    EXPECT_NEAR(wet_snow_mm(year), 300.0 * 0.26112, 0.01) << "only December to February count";
}

TEST(WetSnow, MovesUpTheMountainAsItWarms) {
    const double valley = 4.0;  // warmer than the montane year
    const double mountain = -4.0;
    EXPECT_LT(wet_snow_mm(year_at(valley + 3.0)), wet_snow_mm(year_at(valley)));
    EXPECT_GT(wet_snow_mm(year_at(mountain + 3.0)), wet_snow_mm(year_at(mountain)));
    EXPECT_LT(wet_snow_mm(year_at(20.0)), 1.0);
    EXPECT_LT(wet_snow_mm(year_at(-20.0)), 1.0);
}

TEST(WetSnowChance, IsTheUsualOneInTheUsualYearAndNeverAboveOne) {
    ClimateYear year = montane_year();
    const double scale = usual_wet_snow_mm / wet_snow_mm(year);
    for (ClimateMonth& month : year.months) {
        month.prec_mm *= scale;
    }
    EXPECT_NEAR(wet_snow_chance(year, 0.05), 0.05, 1e-12);
    EXPECT_EQ(wet_snow_chance(year, 0.0), 0.0);
    for (ClimateMonth& month : year.months) {
        month.prec_mm *= 10.0;
    }
    EXPECT_EQ(wet_snow_chance(year, 0.5), 1.0);
}

}  // namespace
}  // namespace forest::wet_snow_test
