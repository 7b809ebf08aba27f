#include "forest/climate/change.hpp"

#include <gtest/gtest.h>

#include "forest/climate/vapour.hpp"
#include "tests/forest/climate/weather.hpp"

namespace forest::change_test {
namespace {

TEST(Warmed, KeepsRelativeHumidity) {
    const ClimateMonth june = alpine_series().years.front().months[5];
    const ClimateMonth warm = warmed(june, 6, 3.0);
    EXPECT_DOUBLE_EQ(warm.vpd_kpa / saturation_pressure_kpa(warm.tmax_degc),
                     june.vpd_kpa / saturation_pressure_kpa(june.tmax_degc));
    EXPECT_DOUBLE_EQ(warm.tmin_degc, june.tmin_degc + 3.0);
    EXPECT_DOUBLE_EQ(warm.abs_tmin_degc.value(), june.abs_tmin_degc.value() + 3.0);
    EXPECT_NEAR(warm.degree_days.value() - june.degree_days.value(), 90.0, 0.2)
        << "nearly all days are above 5.5";
    EXPECT_DOUBLE_EQ(warm.radiation_mjpm2, june.radiation_mjpm2);
}

TEST(Warmed, MovesFrostDaysWithTemperatureAndNeverPastTheMonth) {
    const ClimateYear year = alpine_series().years.front();
    for (const ClimateMonth& month : year.months) {
        double frost_days = 31.0;
        for (const double shift_k : {-20.0, -5.0, -1.0, 0.0, 1.0, 5.0, 20.0}) {
            const ClimateMonth warm = warmed(month, 1, shift_k);
            // No frost day at all says only that they are fewer than half a day.
            EXPECT_LE(warm.frost_days, frost_days + 0.5) << shift_k;
            EXPECT_GE(warm.frost_days, 0.0);
            EXPECT_GE(warm.degree_days.value(), 0.0);
            frost_days = warm.frost_days;
        }
    }
}

TEST(Warmed, ReturnsWhereItCameFrom) {
    // Frost days at the edges hold less than a shift needs; between them there and back is nothing.
    const ClimateMonth april = alpine_series().years.front().months[3];
    const ClimateMonth back = warmed(warmed(april, 4, 1.5), 4, -1.5);
    EXPECT_NEAR(back.frost_days, april.frost_days, 1e-9);
    EXPECT_NEAR(back.degree_days.value(), april.degree_days.value(), 1e-9);
    EXPECT_NEAR(back.vpd_kpa, april.vpd_kpa, 1e-12);
}

TEST(LapseRates, ShipThoseOfTheSwissAlps) {
    const LapseRates rates = LapseRates::shipped();
    EXPECT_DOUBLE_EQ(rates.temperature_kpm[4], -0.0067);
    EXPECT_DOUBLE_EQ(rates.precipitation_mmpm[11], 0.0257);
}

TEST(LapseRates, WantTwelveMonths) {
    EXPECT_THROW(LapseRates::read(climate_table("month,temperature,precipitation\n1,-0.5,1\n")),
                 config::InputError);
    EXPECT_THROW(LapseRates::read(climate_table("month,temperature,precipitation\n1,-5,1\n1,-0.5,1\n")),
                 config::InputError);
}

TEST(AtElevation, CoolsAndWets) {
    const ClimateSeries valley = alpine_series();
    const ClimateSeries high = at_elevation(valley, 1000.0, LapseRates::shipped());
    EXPECT_NEAR(high.years[1].months[6].tave_degc, 17.4 - 6.1, 1e-12);
    EXPECT_NEAR(high.years[1].months[6].prec_mm, 150.0 + 21.6, 1e-12);
    EXPECT_FALSE(high.elevation_m);
}

TEST(AtElevation, KeepsADryMonthDryAndTheMeanOfTheLapseRate) {
    ClimateSeries valley = alpine_series();
    valley.years[0].months[3].prec_mm = 0.0;
    valley.years[1].months[3].prec_mm = 160.0;
    const ClimateSeries high = at_elevation(valley, 500.0, LapseRates::shipped());
    EXPECT_EQ(high.years[0].months[3].prec_mm, 0.0);
    double mean_mm = 0.0;
    for (const ClimateYear& year : high.years) {
        mean_mm += year.months[3].prec_mm / 3.0;
    }
    EXPECT_NEAR(mean_mm, 80.0 + 7.2, 1e-12);
}

TEST(AtElevation, RainsNeverLessThanNothing) {
    const ClimateSeries deep = at_elevation(alpine_series(), -6000.0, LapseRates::shipped());
    for (const ClimateMonth& month : deep.years.front().months) {
        EXPECT_GE(month.prec_mm, 0.0);
    }
}

TEST(ClimateChange, AddsTemperatureAndMultipliesRain) {
    const ClimateYear year = alpine_series().years.front();
    const ClimateYear later = changed(year, ClimateChange::of(2.0, 0.9).scaled(0.5));
    for (std::size_t m = 0; m < 12; ++m) {
        EXPECT_NEAR(later.months[m].tave_degc, year.months[m].tave_degc + 1.0, 1e-12);
        EXPECT_NEAR(later.months[m].prec_mm, year.months[m].prec_mm * 0.95, 1e-12);
    }
    const ClimateYear same = changed(year, {});
    EXPECT_EQ(same.months[3].tmin_degc, year.months[3].tmin_degc);
    EXPECT_EQ(same.months[3].prec_mm, year.months[3].prec_mm);
}

}  // namespace
}  // namespace forest::change_test
