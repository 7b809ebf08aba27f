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

/// The table with each number of a column changed by a factor.
std::string with_factor(int column, double factor) {
    std::istringstream in{alpine_text(2001, 2002)};
    std::string result;
    for (std::string line; std::getline(in, line);) {
        std::istringstream fields{line};
        std::string changed;
        int at = 0;
        for (std::string field; std::getline(fields, field, ','); ++at) {
            const bool value = at == column && line[0] == '2';
            changed += (at == 0 ? "" : ",") + (value ? std::to_string(std::stod(field) * factor) : field);
        }
        result += changed + "\n";
    }
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

TEST(Climate, WarnsOfAColumnThatIsNearlyOneOfItsOwn) {
    std::string text = alpine_text(2001, 2002);
    const std::size_t at = text.find("frost_days");
    ASSERT_NE(at, std::string::npos);
    text.replace(at, 10, "frost_day");
    bool warned = false;
    for (const std::string& warning : read(text).warnings) {
        warned = warned || (warning.find("'frost_day' is not read") != std::string::npos &&
                            warning.find("'frost_days'") != std::string::npos);
    }
    EXPECT_TRUE(warned);
}

TEST(Climate, LeavesColumnsOfOtherQuantitiesAlone) {
    for (const char* other : {"abs_tmax_c", "gdd5_c_d", "vpd_day_kpa"}) {
        std::string text = alpine_text(2001, 2002);
        const std::string replaced = other[0] == 'v'   ? "abs_tmin_c"
                                     : other[0] == 'a' ? "abs_tmin_c"
                                                       : "gdd55_c_d";
        text.replace(text.find(replaced), replaced.size(), other);
        for (const std::string& warning : read(text).warnings) {
            EXPECT_EQ(warning.find("is not read"), std::string::npos) << warning;
        }
    }
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

TEST(Climate, NamesMonthsThatAreMissing) {
    EXPECT_EQ(read(replaced(alpine_text(2001, 2002), alpine_row(2002, 5), "")).error,
              "climate.csv: found no month 5 of 2002, expected twelve months in each year");
    std::string gap =
        alpine_text(2001, 2001) + alpine_text(2003, 2003).substr(std::string{alpine_header}.size());
    EXPECT_EQ(read(gap).error,
              "climate.csv: found no year 2002, expected every year from the first to the last");
}

TEST(Climate, NamesAMonthThatStandsTwice) {
    EXPECT_EQ(
        read(alpine_text(2001, 2001) + alpine_row(2001, 7)).error,
        "climate.csv:14:6: found month 7 of 2001 a second time, expected each month once (first in line 8)");
}

TEST(Climate, KnowsRadiationInWattsByItsSize) {
    EXPECT_EQ(read(with_factor(6, 11.574)).error,
              "climate.csv: found rad_mj_m2_d of 145.8 in the middle month, expected MJ/m2 a day; this looks "
              "like W/m2 "
              "(times 0.0864)");
}

TEST(Climate, KnowsDeficitsInHectopascalByTheirSize) {
    EXPECT_EQ(read(with_factor(7, 10.0)).error,
              "climate.csv: found vpd_kpa above saturation in most months, expected kPa; this looks like hPa "
              "(times "
              "0.1)");
}

TEST(Climate, RefusesWhatCannotBe) {
    EXPECT_EQ(read(replaced(alpine_text(2001, 2001), "9.7,21.4", "21.4,9.7")).error,
              "climate.csv:7:13: found tmax_c '9.7', expected at least tmin_c, 21.4");
    EXPECT_EQ(read(replaced(alpine_text(2001, 2001), "298,3", "298,13")).error,
              "climate.csv:7:42: found abs_tmin_c '13', expected at most tmin_c, 9.7");
    EXPECT_NE(read(replaced(alpine_text(2001, 2001), "0.73", "7.3")).error.find("saturation pressure"),
              std::string::npos);
    EXPECT_NE(read(replaced(alpine_text(2001, 2001), "0.12,28,", "0.12,32,")).error.find("[0, 31]"),
              std::string::npos);
    EXPECT_NE(read(replaced(alpine_text(2001, 2001), ",140,20.6", ",-140,20.6")).error.find("[0, 3000]"),
              std::string::npos);
}

TEST(Climate, WarnsOfWhatIsOnlySuspicious) {
    const Reading outside = read(replaced(alpine_text(2001, 2001), "9.7,21.4,15.4", "9.7,21.4,22.4"));
    EXPECT_EQ(outside.error, "");
    ASSERT_EQ(outside.warnings.size(), 1U);
    EXPECT_EQ(outside.warnings.front(),
              "climate.csv: 1 month with tave_c outside tmin_c and tmax_c, the first in line 7");
    const Reading dry = read(with_factor(5, 0.15));
    ASSERT_EQ(dry.warnings.size(), 1U);
    EXPECT_EQ(dry.warnings.front(),
              "climate.csv: precipitation (mm) of a mean year is 183; is it mm a month?");
}

TEST(Climate, InAnotherUnitIsRefusedWithTheUnitThatFits) {
    const auto error = [](int column, double factor) { return read(with_factor(column, factor)).error; };
    EXPECT_NE(error(5, 1.0 / 30.44)
                  .find("prec_mm: precipitation (mm) of a mean year is 40.1, expected mm a month; "
                        "this looks like mm a day"),
              std::string::npos)
        << error(5, 1.0 / 30.44);
    EXPECT_NE(error(5, 1.0 / 30.44 / 86400.0).find("this looks like kg m-2 s-1"), std::string::npos);
    EXPECT_NE(error(5, 0.001).find("this looks like m a month"), std::string::npos);
    EXPECT_NE(error(6, 1.0 / 3.6).find("this looks like kWh/m2 a day (times 3.6)"), std::string::npos)
        << error(6, 1.0 / 3.6);
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
