#include "coupling/inputs/release/zone_blocks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "tests/coupling/inputs/opened.hpp"

namespace coupling::zone_blocks_test {
namespace {

using config::ExitCode;

constexpr const char* header = "return_period_years,zone,diameter_m,volume_m3,blocks\n";

Opened open_with(const std::string& rows, const std::string& years = "100") {
    const SampleProject project;
    project.write("blocks.csv", header + rows);
    project.replace("scenario.ini", "diameter_m = 0.5\n", "");
    project.replace("scenario.ini", "[targets]",
                    "[hazard]\nblocks = blocks.csv\nreturn_period_years = " + years + "\n[targets]");
    return open(project);
}

std::string all_warnings(const Opened& opened) {
    return std::accumulate(opened.warnings.begin(), opened.warnings.end(), std::string{});
}

TEST(ZoneBlocks, GiveTheRocksOfAReturnPeriod) {
    const Opened opened = open_with("10,1,0.3,,\n100,1,,1.5,60\n300,1,2,,\n");
    ASSERT_TRUE(opened.site) << opened.errors;
    ASSERT_EQ(opened.site->sources.size(), 4U);
    std::uint32_t rocks = 0;
    for (const rockfall::ReleaseSource& source : opened.site->sources) {
        ASSERT_TRUE(source.own_start);
        EXPECT_NEAR(source.own_start->diameter.mean_m(), std::cbrt(6.0 * 1.5 / std::numbers::pi), 1e-12);
        rocks += source.rocks;
    }
    EXPECT_EQ(rocks, 60U);
}

TEST(ZoneBlocks, WithoutANumberShareTheRocksOfTheScenario) {
    const Opened opened = open_with("100,1,0.8,,\n");
    ASSERT_TRUE(opened.site) << opened.errors;
    std::uint32_t rocks = 0;
    for (const rockfall::ReleaseSource& source : opened.site->sources) {
        rocks += source.rocks;
    }
    EXPECT_EQ(rocks, 20U);
}

TEST(ZoneBlocks, OfAZoneWithoutARowDoNotFall) {
    const SampleProject project;
    project.write("blocks.csv", std::string{header} + "100,1,0.8,,\n100,9,0.8,,\n");
    project.write("source.asc", SampleProject::header() + SampleProject::rows([](int column, int row) {
                                    return column == 2 && row >= 3 && row < 7 ? (row < 5 ? "1" : "2") : "0";
                                }));
    project.replace("scenario.ini", "[targets]",
                    "[hazard]\nblocks = blocks.csv\nreturn_period_years = 100\n[targets]");
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    ASSERT_EQ(opened.site->sources.size(), 2U);
    for (const rockfall::ReleaseSource& source : opened.site->sources) {
        EXPECT_EQ(source.zone, 1U);
    }
    const std::string warnings = all_warnings(opened);
    EXPECT_NE(warnings.find("1 zone (2) without rocks of 100 years"), std::string::npos) << warnings;
    EXPECT_NE(warnings.find("zone 9 with rocks of 100 years but no source"), std::string::npos) << warnings;
}

TEST(ZoneBlocks, WithoutAZoneAreThoseOfAllOthers) {
    const SampleProject project;
    project.write("blocks.csv", std::string{header} + "100,,0.8,,40\n100,2,1.6,,5\n");
    project.write("source.asc", SampleProject::header() + SampleProject::rows([](int column, int row) {
                                    return column == 2 && row >= 3 && row < 7 ? std::to_string(row - 2) : "0";
                                }));
    project.replace("scenario.ini", "[targets]",
                    "[hazard]\nblocks = blocks.csv\nreturn_period_years = 100\n[targets]");
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    ASSERT_EQ(opened.site->sources.size(), 4U);
    std::uint32_t others = 0;
    for (const rockfall::ReleaseSource& source : opened.site->sources) {
        EXPECT_NEAR(source.own_start->diameter.mean_m(), source.zone == 2 ? 1.6 : 0.8, 1e-12);
        others += source.zone == 2 ? 0 : source.rocks;
    }
    EXPECT_EQ(others, 40U);
}

TEST(ZoneBlocks, TellWhatIsWrong) {
    struct Bad {
        std::string rows;
        std::string message;
    };
    for (const Bad& bad : {Bad{"100,1,,,\n",
                               "blocks.csv:2:1: found no size of the rocks, expected diameter_m, "
                               "mass_t or volume_m3"},
                           Bad{"100,1,1,2,\n", "found volume_m3 beside diameter_m"},
                           Bad{"100,1,1,,\n100,1,2,,\n", "found zone 1 a second time with 100 years"},
                           Bad{"", "blocks.csv: found no rows"}}) {
        const Opened opened = open_with(bad.rows);
        EXPECT_FALSE(opened.site) << bad.rows;
        EXPECT_EQ(opened.code, ExitCode::data);
        EXPECT_NE(opened.errors.find(bad.message), std::string::npos) << opened.errors;
    }
}

TEST(ZoneBlocks, NameTheReturnPeriodsThereAre) {
    const Opened opened = open_with("10,1,1,,\n300,1,2,,\n", "50");
    EXPECT_FALSE(opened.site);
    EXPECT_EQ(opened.code, ExitCode::settings);
    EXPECT_NE(
        opened.errors.find("found hazard.return_period_years 50, expected one of hazard.blocks: 10, 300"),
        std::string::npos)
        << opened.errors;
}

TEST(ZoneBlocks, ThatGetSmallerAreDoubted) {
    const Opened opened = open_with("10,1,2,,\n100,1,1,,\n");
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_NE(all_warnings(opened).find("zone 1: rocks of 1 m with 100 years, of 2 m with 10"),
              std::string::npos)
        << all_warnings(opened);
}

}  // namespace
}  // namespace coupling::zone_blocks_test
