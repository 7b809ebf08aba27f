#include "coupling/inputs/forest/climate_input.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "forest/climate/summary.hpp"
#include "tests/coupling/inputs/forest_project.hpp"

namespace coupling::climate_input_test {
namespace {

using config::ExitCode;

std::string errors_of(const ForestProject& project, const std::vector<std::string>& overrides = {}) {
    return open(project, overrides).errors;
}

double july_degc(const YearWeather& weather) {
    return weather.units[0].months[6].tave_degc;
}

/// The climate of a project at the height of its own series.
YearWeather weather_of(const Opened& opened, int year, std::uint32_t replicate = 0) {
    const std::array elevation_m{500.0};
    return opened.site->forest->climates.front().source.weather(year, replicate, elevation_m);
}

TEST(Climate, ThatEndsBeforeTheRunIsRefusedUnlessItRepeats) {
    const ForestProject project;
    const Opened again = open(project, {"run.years=10", "climate.sequence=repeat"});
    ASSERT_TRUE(again.site) << again.errors;
    EXPECT_EQ(weather_of(again, 2008).source_year, 2008);
    EXPECT_EQ(weather_of(again, 2009).source_year, 2001);
}

TEST(Climate, StaysInsideItsWindow) {
    const ForestProject project;
    const Opened opened = open(project, {"climate.window_first_year=2003", "climate.window_last_year=2005",
                                         "climate.sequence=random", "run.years=400"});
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.site->forest->first_year(), 2003);
    std::set<int> drawn;
    int other_in_second_replicate = 0;
    for (int year = 2003; year < 2403; ++year) {
        drawn.insert(weather_of(opened, year).source_year);
        other_in_second_replicate +=
            weather_of(opened, year, 1).source_year != weather_of(opened, year).source_year ? 1 : 0;
    }
    EXPECT_EQ(drawn, (std::set<int>{2003, 2004, 2005}));
    // Independent draws from three years differ in two of three.
    EXPECT_NEAR(other_in_second_replicate, 400.0 * 2.0 / 3.0, 4.0 * std::sqrt(400.0 * 2.0 / 9.0));
}

TEST(Climate, HasTheDryYearsThatWereAskedFor) {
    const ForestProject project;
    const Opened usual = open(project);
    const Opened dry = open(project, {"climate.dry_years=2003, 2050", "climate.dry_season_k=3",
                                      "climate.dry_season_precipitation=0.4"});
    ASSERT_TRUE(usual.site && dry.site) << usual.errors << dry.errors;
    for (int year = 2001; year <= 2004; ++year) {
        const YearWeather with = weather_of(dry, year);
        const YearWeather without = weather_of(usual, year);
        for (std::size_t month = 0; month < 12; ++month) {
            const bool is_changed = year == 2003 && month >= 3 && month < 9;
            const auto& here = with.units[0].months[month];
            const auto& there = without.units[0].months[month];
            EXPECT_NEAR(here.tave_degc, there.tave_degc + (is_changed ? 3.0 : 0.0), 1e-9);
            EXPECT_NEAR(here.prec_mm, there.prec_mm * (is_changed ? 0.4 : 1.0), 1e-9);
        }
    }
    EXPECT_EQ(std::count_if(dry.warnings.begin(), dry.warnings.end(),
                            [](const std::string& sentence) {
                                return sentence.find("climate.dry_years 2050") != std::string::npos;
                            }),
              1);
}

TEST(Climate, NeedsTheHeightOfItsPlaceOnce) {
    const ForestProject project;
    project.replace("scenario.ini", "elevation_m = 500\n", "");
    EXPECT_EQ(errors_of(project),
              "scenario.ini:23:8: found neither climate.elevation_m nor a column elev_m in "
              "climate.csv, expected the height of the place that the series is of; "
              "set climate.elevation_m");
    std::string text = project.read("climate.csv");
    for (std::size_t end = text.find('\n'), line = 0; end != std::string::npos; ++line) {
        text.insert(end, line == 0 ? ",elev_m" : ",900");
        end = text.find('\n', text.find('\n', end) + 1);
    }
    project.write("climate.csv", text);
    EXPECT_EQ(errors_of(project), "");
    EXPECT_NE(errors_of(project, {"climate.elevation_m=500"}).find("expected the elev_m of the series, 900"),
              std::string::npos);
}

TEST(Climate, GetsColderUpTheSlope) {
    const ForestProject project;
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    const std::array elevations_m{500.0, 1500.0};
    const YearWeather weather = opened.site->forest->climates.front().source.weather(2001, 0, elevations_m);
    // July: -0.61 K and 2.16 mm for each 100 m (lapse_rates.csv).
    EXPECT_NEAR(weather.units[0].months[6].tave_degc, 15.0, 1e-12);
    EXPECT_NEAR(weather.units[1].months[6].tave_degc, 15.0 - 6.1, 1e-9);
    EXPECT_NEAR(weather.units[1].months[6].prec_mm, 110.0 + 21.6, 1e-9);
    EXPECT_GT(opened.site->forest->climates.front().source.degree_days(500.0),
              opened.site->forest->climates.front().source.degree_days(1500.0));
}

TEST(Climate, ChangesEvenlyOverTheYearsGiven) {
    const ForestProject project;
    const Opened opened =
        open(project, {"climate.window_last_year=2001", "climate.sequence=repeat", "climate.change_years=4",
                       "climate.temperature_change_k=2", "climate.precipitation_change=0.8"});
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_NEAR(july_degc(weather_of(opened, 2001)), 15.5, 1e-12);
    EXPECT_NEAR(july_degc(weather_of(opened, 2002)), 16.0, 1e-12);
    EXPECT_NEAR(july_degc(weather_of(opened, 2004)), 17.0, 1e-12);
    EXPECT_NEAR(july_degc(weather_of(opened, 2050)), 17.0, 1e-12);
    EXPECT_NEAR(weather_of(opened, 2002).units[0].months[0].prec_mm, 110.0 * 0.9, 1e-12);
}

TEST(Climate, MayChangeByMonth) {
    const ForestProject project;
    std::string rows = "month,temperature_k,precipitation\n";
    for (int month = 1; month <= 12; ++month) {
        rows += std::to_string(month) + "," + std::to_string(month) + ",1\n";
    }
    project.write("change.csv", rows);
    const Opened opened = open(project, {"climate.change=change.csv"});
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_NEAR(july_degc(weather_of(opened, 2001)), 15.0 + 7.0, 1e-12);
}

TEST(Climate, TakesItsCarbonDioxideFromTheRecordOrTheUser) {
    const ForestProject project;
    const Opened record = open(project);
    ASSERT_TRUE(record.site) << record.errors;
    EXPECT_EQ(weather_of(record, 2003).co2_ppm, forest::Co2Series::shipped().ppm(2003));
    EXPECT_FALSE(weather_of(record, 2003).view().co2_response);
    const Opened fixed = open(project, {"climate.co2_ppm=500", "forest.co2_response=yes"});
    EXPECT_EQ(weather_of(fixed, 2003).co2_ppm, 500.0);
    EXPECT_TRUE(weather_of(fixed, 2003).view().co2_response);
}

}  // namespace
}  // namespace coupling::climate_input_test
