#include "coupling/inputs/forest/climate_variants.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/coupling/inputs/forest_project.hpp"

namespace coupling::climate_variants_test {
namespace {

const std::vector<std::string> with_variants{"climate.variants=climates.csv"};

Opened open_with(const ForestProject& project, const std::string& rows,
                 std::vector<std::string> overrides = {}) {
    project.write("climates.csv", rows);
    overrides.insert(overrides.end(), with_variants.begin(), with_variants.end());
    return open(project, overrides);
}

std::string errors_of(const ForestProject& project, const std::string& rows,
                      const std::vector<std::string>& overrides = {}) {
    return open_with(project, rows, overrides).errors;
}

double july_degc(const Opened& opened, std::size_t climate, int year) {
    const std::array elevation_m{500.0};
    return opened.site->forest->climates[climate]
        .source.weather(year, 0, elevation_m)
        .units[0]
        .months[6]
        .tave_degc;
}

TEST(ClimateVariants, AreOneClimateAsGivenWithoutATable) {
    const Opened opened = open(ForestProject{});
    ASSERT_TRUE(opened.site) << opened.errors;
    ASSERT_EQ(opened.site->forest->climates.size(), 1U);
    EXPECT_EQ(opened.site->forest->climates.front().name, "as_given");
}

TEST(ClimateVariants, WithAFileOfTheirOwnTellWhatTheyTakeOver) {
    const ForestProject project;
    project.write("other.csv", project.read("climate.csv"));
    const auto told = [&](const std::string& rows) {
        const Opened opened = open_with(project, rows, {"climate.temperature_change_k=1"});
        EXPECT_TRUE(opened.site) << opened.errors;
        return std::count_if(opened.warnings.begin(), opened.warnings.end(), [](const std::string& warning) {
            return warning.find(
                       "climate 'other': a file of its own, but climate.elevation_m, "
                       "climate.temperature_change_k as [climate] has it") != std::string::npos;
        });
    };
    EXPECT_EQ(told("name,file,temperature_change_k\nother,other.csv,\n"), 1);
    EXPECT_EQ(told("name,file,temperature_change_k\nother,other.csv,0\n"), 0);
    EXPECT_EQ(told("name,file,temperature_change_k\nother,,\n"), 0);
}

TEST(ClimateVariants, SayWhereTheyReplaceAnOverride) {
    const ForestProject project;
    const auto warned = [&](const std::string& rows, const std::vector<std::string>& overrides) {
        const Opened opened = open_with(project, rows, overrides);
        EXPECT_TRUE(opened.site) << opened.errors;
        return std::count_if(opened.warnings.begin(), opened.warnings.end(), [](const std::string& warning) {
            return warning.find(
                       "--set climate.temperature_change_k=1 has no effect on climate warm, hot: the rows "
                       "of climate.variants go before it") != std::string::npos;
        });
    };
    const std::string rows = "name,temperature_change_k\nas_is,\nwarm,2\nhot,4\n";
    EXPECT_EQ(warned(rows, {"climate.temperature_change_k=1"}), 1);
    EXPECT_EQ(warned(rows, {"climate.precipitation_change=0.9"}), 0) << "it holds for all";
    EXPECT_EQ(warned(rows, {}), 0);
}

TEST(ClimateVariants, TakeFromTheSettingsWhatTheirRowLeavesOut) {
    const ForestProject project;
    const Opened opened =
        open_with(project,
                  "name,temperature_change_k,precipitation_change,change_years\npresent,0,,\nwarm,2,,\n"
                  "later,,0.5,4\n",
                  {"climate.temperature_change_k=1", "climate.precipitation_change=0.9"});
    ASSERT_TRUE(opened.site) << opened.errors;
    const ForestSite& forest = *opened.site->forest;
    ASSERT_EQ(forest.climates.size(), 3U);
    EXPECT_EQ(forest.climates[1].name, "warm");
    EXPECT_NEAR(july_degc(opened, 0, 2001), 15.0, 1e-12);
    EXPECT_NEAR(july_degc(opened, 1, 2001), 17.0, 1e-12);
    EXPECT_NEAR(july_degc(opened, 2, 2001), 15.25, 1e-12);
    EXPECT_NEAR(forest.climates[1].source.change.precipitation[0], 0.9, 1e-12);
    EXPECT_NEAR(forest.climates[2].source.change.precipitation[0], 0.5, 1e-12);
    // The file that all share is read, and listed among the inputs, once.
    EXPECT_EQ(std::count_if(opened.site->inputs.begin(), opened.site->inputs.end(),
                            [](const InputFile& input) { return input.name == "climate.csv"; }),
              1);
}

TEST(ClimateVariants, MayHaveASeriesOfTheirOwn) {
    const ForestProject project;
    project.write("valley.csv", ForestProject::climate_of(2001, 2030));
    const Opened opened =
        open_with(project, "name,file,elevation_m\npresent,,\nvalley,valley.csv,400\n", {"climate.file="});
    EXPECT_NE(opened.errors.find("climates.csv:2:1: found climate 'present': neither a file in its row nor "
                                 "climate.file, expected a table of monthly climate"),
              std::string::npos)
        << opened.errors;
    const Opened both = open_with(project, "name,file,elevation_m\npresent,,\nvalley,valley.csv,400\n");
    ASSERT_TRUE(both.site) << both.errors;
    EXPECT_EQ(both.site->forest->climates[1].source.series.last_year(), 2030);
    EXPECT_EQ(both.site->forest->climates[1].source.series.elevation_m, 400.0);
    const bool listed = std::any_of(
        both.site->inputs.begin(), both.site->inputs.end(),
        [](const InputFile& input) { return input.role == "climate valley" && input.name == "valley.csv"; });
    EXPECT_TRUE(listed);
}

TEST(ClimateVariants, BeginInTheSameYearAndDrawTheSameOnes) {
    const ForestProject project;
    const Opened opened = open_with(
        project, "name,temperature_change_k,window_first_year\npresent,0,2003\nwarm,2,2003\nlate,,\n",
        {"climate.sequence=random", "run.years=300"});
    ASSERT_TRUE(opened.site) << opened.errors;
    const auto& climates = opened.site->forest->climates;
    int other = 0;
    for (int year = 2003; year < 2303; ++year) {
        EXPECT_EQ(climates[0].source.source_of(year, 5), climates[1].source.source_of(year, 5));
        other += climates[0].source.source_of(year, 5) != climates[0].source.source_of(year, 6) ? 1 : 0;
    }
    EXPECT_GT(other, 200);
    EXPECT_EQ(climates[2].source.first_year, 2003) << "that of the first climate";
}

TEST(ClimateVariants, ReplaceAChangeByMonthAsAWhole) {
    const ForestProject project;
    std::string rows = "month,temperature_k,precipitation\n";
    for (int month = 1; month <= 12; ++month) {
        rows += std::to_string(month) + ",3,0.7\n";
    }
    project.write("change.csv", rows);
    const Opened opened =
        open_with(project, "name,temperature_change_k,change\nmonths,,\nwarm,2,\nagain,,change.csv\n",
                  {"climate.change=change.csv"});
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_NEAR(july_degc(opened, 0, 2001), 18.0, 1e-12);
    EXPECT_NEAR(july_degc(opened, 1, 2001), 17.0, 1e-12);
    EXPECT_NEAR(opened.site->forest->climates[1].source.change.precipitation[0], 1.0, 1e-12);
    EXPECT_NEAR(july_degc(opened, 2, 2001), 18.0, 1e-12);
    EXPECT_EQ(errors_of(project, "name,temperature_change_k,change\nboth,2,change.csv\n"),
              "climates.csv:2:8: found change beside temperature_change_k or precipitation_change, expected "
              "only one of them; leave one of the fields empty");
}

struct BadTable {
    const char* rows;
    const char* error;
};

TEST(ClimateVariants, TellFaultsOfTheirTable) {
    const ForestProject project;
    for (const BadTable& bad :
         {BadTable{"name,file\na,nowhere.csv\n", "climates.csv:2:3: found "},
          BadTable{"name\n../warm\n", "climates.csv:2:1: found name '../warm', expected at most 100 letters"},
          BadTable{"name,temperature_change\nwarm,2\n",
                   "climates.csv: found column 'temperature_change', which has no meaning, expected "
                   "temperature_change_k"},
          BadTable{"name\n", "climates.csv: found no climate"},
          BadTable{"name,co2_ppm\nwarm,500\n", "co2_ppm without forest.co2_response"},
          BadTable{
              "name,window_last_year\nwarm,2050\n",
              "climates.csv:2:6: found climate 'warm': climate.window_last_year 2050, expected a year of "
              "climate.csv, 2001 to 2008"},
          BadTable{"file\nclimate.csv\n", "name"}}) {
        const std::string errors = errors_of(project, bad.rows);
        EXPECT_NE(errors.find(bad.error), std::string::npos) << bad.rows << errors;
    }
    EXPECT_NE(open(project, {"climate.variants=none.csv"}).errors.find("none.csv"), std::string::npos);
}

TEST(ClimateVariants, NameTheClimateWhoseSeriesEndsBeforeTheRun) {
    const ForestProject project;
    project.write("short.csv", ForestProject::climate_of(2001, 2002));
    EXPECT_EQ(errors_of(project, "name,file\npresent,\nshort,short.csv\n"),
              "climates.csv:3:7: found climate 'short': short.csv has years 2001 to 2002, but none for 2003, "
              "expected all years of the run, 2001 to 2004, or climate.sequence = repeat or random");
}

}  // namespace
}  // namespace coupling::climate_variants_test
