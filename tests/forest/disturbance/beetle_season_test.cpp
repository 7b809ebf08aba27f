#include "forest/disturbance/beetle_season.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/forest/small_forest.hpp"

namespace forest::beetle_season_test {
namespace {

const config::Angle alps = config::Angle::from_degrees(47.0);

ClimateYear constant_year(double degc) {
    ClimateYear year;
    for (ClimateMonth& month : year.months) {
        month.tmin_degc = month.tmax_degc = month.tave_degc = degc;
    }
    return year;
}

ClimateYear warmer(double kelvin) {
    ClimateYear year = montane_year();
    for (ClimateMonth& month : year.months) {
        month.tave_degc += kelvin;
        month.tmin_degc += kelvin;
        month.tmax_degc += kelvin;
    }
    return year;
}

TEST(BeetleDays, MeetTheMonthsInTheirMiddleAndStayBetween) {
    const BeetleDays days = beetle_days(montane_year(), alps);
    EXPECT_NEAR(days.mean_degc[14], -4.0, 1e-9);
    EXPECT_NEAR(days.mean_degc[195], 15.0, 1e-9);
    EXPECT_NEAR(days.max_degc[348], 2.0, 1e-9);
    EXPECT_NEAR(days.mean_degc[0], -3.5, 0.3) << "half-way from December to January";
    for (std::size_t d = 14; d < 195; ++d) {
        EXPECT_LE(days.mean_degc[d], days.mean_degc[d + 1] + 1e-12) << d;
    }
    double july_degc = 0.0;
    for (std::size_t d = 181; d < 212; ++d) {
        july_degc += days.mean_degc[d] / 31.0;
    }
    EXPECT_NEAR(july_degc, 15.0, 0.5);
}

TEST(Broods, FollowTheDegreeDaysOfAConstantYear) {
    // 11.7 K a day wake them on 12 April; in the dark the bark has 12.607 degree-days a day, a brood 45 days:
    // 27 May, 11 July, and on 25 August the days are too short.
    EXPECT_EQ(broods_of(beetle_days(constant_year(20.0), alps), 0.0), (Broods{3, true}));
    // 7.7 K: 19 April; 8.391 degree-days a day, 67 days: 25 June, 31 August.
    EXPECT_EQ(broods_of(beetle_days(constant_year(16.6), alps), 0.0), (Broods{2, true}));
    EXPECT_EQ(broods_of(beetle_days(constant_year(16.4), alps), 0.0), (Broods{0, false})) << "never flies";
}

TEST(Broods, AreMoreWithWarmthAndLight) {
    int before = 0;
    for (double kelvin = -6.0; kelvin < 8.0; kelvin += 0.5) {
        const int now = broods_of(beetle_days(warmer(kelvin), alps), 0.2).generations;
        EXPECT_GE(now, before) << kelvin;
        before = now;
    }
    EXPECT_GE(before, 2);
    EXPECT_EQ(broods_of(beetle_days(warmer(-6.0), alps), 0.2).generations, 0);
    for (double kelvin = -4.0; kelvin < 6.0; kelvin += 1.0) {
        const BeetleDays days = beetle_days(warmer(kelvin), alps);
        EXPECT_GE(broods_of(days, 1.0).generations, broods_of(days, 0.0).generations);
    }
}

TEST(Broods, AreOneAndASisterInTheMontaneBelt) {
    EXPECT_EQ(broods_of(beetle_days(montane_year(), alps), 0.15), (Broods{1, true}));
}

TEST(ColdDays, AreHalfOfAllAtTheLimit) {
    EXPECT_NEAR(cold_days(constant_year(-15.0)), 182.5, 1e-6);
    EXPECT_NEAR(cold_days(constant_year(0.0)), 0.0, 1e-3);
}

TEST(WinterSurvival, FallsWithColdDays) {
    EXPECT_NEAR(winter_survival(0.0), 0.6, 1e-12);
    EXPECT_NEAR(winter_survival(10.0), 0.6 * std::exp(-1.005), 1e-9);
}

}  // namespace
}  // namespace forest::beetle_season_test
