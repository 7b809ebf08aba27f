#include "coupling/inputs/release/zone_blocks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "tests/coupling/inputs/opened.hpp"

namespace coupling::zone_blocks_test {
namespace {

constexpr const char* header = "return_period_years,zone,diameter_m,volume_m3,blocks\n";

Opened open_table(const std::string& blocks, const std::string& years = "100") {
    const SampleProject project;
    project.write("blocks.csv", blocks);
    project.replace("scenario.ini", "diameter_m = 0.5\n", "");
    project.replace("scenario.ini", "[targets]",
                    "[hazard]\nblocks = blocks.csv\nreturn_period_years = " + years + "\n[targets]");
    return open(project);
}

Opened open_with(const std::string& rows, const std::string& years = "100") {
    return open_table(header + rows, years);
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

TEST(ZoneBlocks, AreReadUnderOtherNamesAndInOtherUnits) {
    for (const char* blocks :
         {"return_period_years,volume_dm3\n100,1500\n", "Wiederkehrperiode_Jahre,Volumen [m³]\n100,1.5\n",
          "Wiederkehrdauer;Kubatur (l)\n100;1500\n", "periode_de_retour,Volume m3\n100,1.5\n",
          "Tempo di ritorno [anni],volume_m3\n100,1.5\n",
          "recurrence interval (years),volume_litre\n100,1500\n"}) {
        SCOPED_TRACE(blocks);
        const Opened opened = open_table(blocks);
        ASSERT_TRUE(opened.site) << opened.errors;
        for (const rockfall::ReleaseSource& source : opened.site->sources) {
            EXPECT_NEAR(source.own_start->diameter.mean_m(), std::cbrt(6.0 * 1.5 / std::numbers::pi), 1e-12);
        }
    }
}

TEST(ZoneBlocks, InAUnitThatNobodyKnowsAreRefusedWithWhatToDo) {
    const Opened opened = open_table("return_period_years,volume\n100,1.5\n");
    EXPECT_FALSE(opened.site);
    EXPECT_NE(opened.errors.find("volume"), std::string::npos) << opened.errors;
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

}  // namespace
}  // namespace coupling::zone_blocks_test
