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

}  // namespace
}  // namespace coupling::climate_variants_test
