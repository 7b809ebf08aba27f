// Events that a scenario asks for, and what people do after them, in whole runs.

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "tests/coupling/parts_of_text.hpp"
#include "tests/runs/years.hpp"

namespace coupling::events_test {
namespace {

using text_checks::has;

/// The forest alone, four years from 2001.
constexpr const char* forest_alone =
    "run scenario.ini --quiet --overwrite --set trees.file= --set stands.records=records.csv --set "
    "run.rockfall_every=0 --set climate.sequence=random ";

/// Stems that beetles took, by regime and year.
std::map<std::string, std::map<int, double>> killed_by_beetles(const ForestProject& project) {
    const config::Table deaths = table(project, "out/tables/mortality.csv");
    std::map<std::string, std::map<int, double>> stems;
    for (std::size_t row = 0; row < deaths.rows(); ++row) {
        if (deaths.text(row, "cause") == "beetle") {
            stems[deaths.text(row, "regime")][static_cast<int>(number(deaths, row, "year"))] +=
                number(deaths, row, "stems_pha");
        }
    }
    return stems;
}

TEST(BeetleYears, BringBeetlesFromOutsideToAllRegimesAlike) {
    const ForestProject project;
    const std::string settings = std::string{forest_alone} +
                                 "--set run.replicates=6 --set regimes.list=none,storm_left --set "
                                 "disturbance.beetle=yes --set disturbance.beetle_background=0 ";
    ASSERT_EQ(call(project, settings).code, 0);
    EXPECT_TRUE(killed_by_beetles(project).empty()) << "none come of themselves";
    const std::string others = project.read("out/tables/stands.csv");

    const std::string asked = "--set disturbance.beetle_years=2002 --set disturbance.beetle_years_pha=0.99 ";
    const Outcome outcome = call(project, settings + asked);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    auto killed = killed_by_beetles(project);
    EXPECT_EQ(killed["none"], killed["storm_left"]) << "which does nothing either";
    EXPECT_EQ(killed["none"][1], 0.0) << "nothing before";
    EXPECT_GT(killed["none"][2], 0.0);
    EXPECT_NE(project.read("out/tables/stands.csv"), others);
    EXPECT_TRUE(has(project.read("out/report.html"), "Asked for: bark beetles from outside in 2002"));

    // Years before the run and before beetles begin do nothing, and are warned of.
    const Outcome outside = call(project, settings + "--set disturbance.beetle_years=2000,2050");
    EXPECT_TRUE(has(outside.err, "disturbance.beetle_years 2000") && has(outside.err, "beetle_years 2050"))
        << outside.err;
    EXPECT_EQ(project.read("out/tables/stands.csv"), others);
    const Outcome early = call(project, settings + asked + "--set disturbance.first_year=2003");
    EXPECT_TRUE(has(early.err, "a year from disturbance.first_year (2003) on")) << early.err;
    EXPECT_EQ(project.read("out/tables/stands.csv"), others);
    const Outcome off = call(project, std::string{forest_alone} + asked);
    EXPECT_TRUE(has(off.err, "disturbance.beetle_years without disturbance.beetle = yes")) << off.err;
    EXPECT_FALSE(has(project.read("out/report.html"), "Asked for: bark beetles"));
}

TEST(StormYears, AreSalvagedAndPlantedTheYearAfterWhereWoodWasTaken) {
    const ForestProject project;
    project.write("salvage.csv",
                  "name,treatment,first_year,every_years,from_damage_m3pha,share,where,after_years,species,"
                  "plants_pha\n"
                  "salvage,salvage,1,1,5,0.9,,,,\nplanting,plant,,,,,cuts_of:salvage,1,abal,2500\n");
    const Outcome outcome =
        call(project, std::string{forest_alone} +
                          "--set run.replicates=2 --set regimes.list=storm_left,salvage.csv --set "
                          "disturbance.storm_years=2002 --set disturbance.storm_years_intensity=0.9");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table work = table(project, "out/tables/interventions.csv");
    std::map<std::string, std::string> years;
    for (std::size_t row = 0; row < work.rows(); ++row) {
        const std::string& name = work.text(row, "intervention");
        years[name] += work.text(row, "year") + ' ';
        if (name == "planting") {
            EXPECT_GT(number(work, row, "plants"), 0.0);
            EXPECT_GT(number(work, row, "area_ha"), 0.01);
            EXPECT_LT(number(work, row, "area_ha"), 0.8) << "not the whole forest";
        }
    }
    EXPECT_EQ(years["salvage"], "2 2 ") << "both replicates, in the year of the storm";
    EXPECT_EQ(years["planting"], "3 3 ");
    EXPECT_TRUE(
        has(project.read("out/report.html"), "acts where salvage has salvaged, 1 year after salvage"));
}

}  // namespace
}  // namespace coupling::events_test
