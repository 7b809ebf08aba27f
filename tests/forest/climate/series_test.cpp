#include "forest/climate/series.hpp"

#include <gtest/gtest.h>

#include "forest/climate/vapour.hpp"
#include "tests/forest/climate/weather.hpp"

namespace forest::series_test {
namespace {

struct Reading {
    std::string error;
    std::vector<std::string> warnings;
};

Reading read(const std::string& text) {
    Reading result;
    config::Warnings warnings;
    try {
        read_climate(climate_table(text), warnings);
    } catch (const config::InputError& error) {
        result.error = error.what();
    }
    result.warnings = warnings.all();
    return result;
}

TEST(Climate, IsReadMonthByMonth) {
    const ClimateSeries series = alpine_series(2001, 2003);
    ASSERT_EQ(series.years.size(), 3U);
    EXPECT_EQ(series.last_year(), 2003);
    const ClimateMonth& june = series.find(2002)->months[5];
    EXPECT_DOUBLE_EQ(june.tmin_degc, 9.7);
    EXPECT_DOUBLE_EQ(june.tmax_degc, 21.4);
    EXPECT_DOUBLE_EQ(june.prec_mm, 140.0);
    EXPECT_DOUBLE_EQ(june.radiation_mjpm2, 20.6);
    EXPECT_DOUBLE_EQ(june.vpd_kpa, 0.73);
    EXPECT_DOUBLE_EQ(june.degree_days.value(), 298.0);
    EXPECT_DOUBLE_EQ(june.abs_tmin_degc.value(), 3.0);
    EXPECT_EQ(series.find(2004), nullptr);
}

TEST(Climate, OfAGoodTableRaisesNoWarning) {
    const Reading reading = read(alpine_text(1961, 1990));
    EXPECT_EQ(reading.error, "");
    EXPECT_TRUE(reading.warnings.empty()) << reading.warnings.front();
}

TEST(Climate, MakesWhatIsMissingFromTemperaturesAndSaysSo) {
    std::string text = "year,month,tmin_c,tmax_c,prec_mm,rad_mj_m2_d\n";
    for (int month = 1; month <= 12; ++month) {
        text += "2001," + std::to_string(month) + ",2,12,100,12\n";
    }
    config::Warnings warnings;
    const ClimateSeries series = read_climate_of_one_place(climate_table(text), warnings);
    const ClimateMonth& april = series.years.front().months[3];
    EXPECT_DOUBLE_EQ(april.tave_degc, 7.0);
    EXPECT_DOUBLE_EQ(april.vpd_kpa, vpd_from_temperatures_kpa(2.0, 12.0));
    EXPECT_NEAR(april.frost_days, 30.0 * 0.25249, 1e-3) << "a minimum below 0 lies 2/3 of a deviation away";
    EXPECT_FALSE(april.degree_days);
    EXPECT_EQ(warnings.all().size(), 3U);
}

TEST(Climate, OfSeveralElevationsIsOneSeriesEach) {
    std::string text = "elev_m," + std::string{alpine_header};
    for (const char* const elevation : {"1500,", "500,"}) {
        for (int month = 1; month <= 12; ++month) {
            text += elevation + alpine_row(2001, month);
        }
    }
    config::Warnings warnings;
    const std::vector<ClimateSeries> all = read_climate(climate_table(text), warnings);
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all.front().elevation_m, 500.0);
    EXPECT_EQ(all.back().elevation_m, 1500.0);
    EXPECT_THROW(read_climate_of_one_place(climate_table(text), warnings), config::InputError);
}

}  // namespace
}  // namespace forest::series_test
