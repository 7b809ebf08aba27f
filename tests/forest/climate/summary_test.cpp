#include "forest/climate/summary.hpp"

#include <gtest/gtest.h>

#include "tests/forest/climate/weather.hpp"

namespace forest::summary_test {
namespace {

TEST(ClimateSummary, AddsUpAYear) {
    const ClimateYear year = alpine_series().years.front();
    const ClimateSummary summary = summary_of(year);
    EXPECT_NEAR(summary.mean_degc, 7.5, 0.1);
    EXPECT_DOUBLE_EQ(summary.prec_mm, 1220.0);
    EXPECT_DOUBLE_EQ(summary.degree_days, 1642.0);
    EXPECT_DOUBLE_EQ(summary.coldest_month_degc, -2.5);
    EXPECT_DOUBLE_EQ(summary.lowest_degc, -15.0);
    EXPECT_DOUBLE_EQ(summary.frost_free_days, 365.0 - 134.0);
    EXPECT_EQ(summary.first_growing_month, 4);
    EXPECT_EQ(summary.last_growing_month, 10);
    EXPECT_NEAR(summary.growing_season_days, 209.0, 3.0);
}

TEST(DegreeDays, OfMonthlyMeansAreNearThoseOfDays) {
    // The table's own were summed from days; without them the scatter of 3 K must do.
    ClimateYear year = alpine_series().years.front();
    const double of_days = degree_days(year);
    for (ClimateMonth& month : year.months) {
        month.degree_days.reset();
    }
    EXPECT_NEAR(degree_days(year), of_days, 0.03 * of_days);
}

TEST(DegreeDays, FallWithTheirBase) {
    const ClimateYear year = alpine_series().years.front();
    EXPECT_GT(degree_days(year, 0.0), degree_days(year, 2.0));
    EXPECT_GT(degree_days(year, 5.0), degree_days(year, 6.0));
    // Above a base that no day is below, a degree-day is a day's mean.
    double expected = 0.0;
    constexpr std::array days{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    for (std::size_t m = 0; m < 12; ++m) {
        expected += days[m] * (year.months[m].tave_degc + 40.0);
    }
    EXPECT_NEAR(degree_days(year, -40.0), expected, 1e-6);
}

TEST(ClimateSummary, OfAFrozenYearHasNoGrowingSeason) {
    ClimateYear year = alpine_series().years.front();
    for (ClimateMonth& month : year.months) {
        month.tave_degc = -20.0;
        month.degree_days.reset();
    }
    const ClimateSummary summary = summary_of(year);
    EXPECT_EQ(summary.first_growing_month, 0);
    EXPECT_NEAR(summary.degree_days, 0.0, 1e-9);
    EXPECT_NEAR(summary.growing_season_days, 0.0, 1e-9);
}

}  // namespace
}  // namespace forest::summary_test
