// What practitioners get wrong on their first day and the program only warns of: it stands on the first
// screen of the page. What it refuses is in tests/refusals/first_day.cases.

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "tests/runs/years.hpp"

namespace coupling::mistaken_input_test {
namespace {

/// What stands on a page above its heading.
std::string first_screen(const SampleProject& project, const std::string& page) {
    const std::string text = project.read(page);
    return text.substr(0, text.find("<h2>"));
}

TEST(MistakenInputPartly, StandsOnTheFirstScreenAndInTheClosingLinesOfAQuietRun) {
    const SampleProject project;
    project.write("areas.csv",
                  "zone,wkt\n1,\"POLYGON ((995 2030, 1015 2030, 1015 2070, 995 2070, 995 2030))\"\n"
                  "1,\"POLYGON ((1020 2030, 1030 2030, 1030 2070, 1020 2070, 1020 2030))\"\n");
    project.replace("scenario.ini", "source = source.asc", "source_shapes = areas.csv");
    project.replace("trees.csv", "1060,2050", "1060,2500");
    const Outcome outcome = call(project, "run scenario.ini --quiet");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    const std::string screen = first_screen(project, "out/report.html");
    for (const std::string part :
         {"with 50 % of its area (400 m2 of 800 m2) off the terrain; no rock starts there",
          "1 of 3 trees off the terrain",
          "only 20 rocks are released in all: a share of 50 % is uncertain by 22"}) {
        EXPECT_NE(outcome.err.find(part), std::string::npos) << part << '\n' << outcome.err;
        EXPECT_NE(screen.find(part), std::string::npos) << part << '\n' << screen;
    }
}

TEST(WarningsOfARun, AreItsClosingLines) {
    const SampleProject project;
    project.replace("trees.csv", "1060,2050", "1060,2500");
    const Outcome both = shell(project, "\"$bannwald\" run scenario.ini --set release.rocks=200 2>&1");
    ASSERT_EQ(both.code, 0) << both.out;
    const std::size_t results = both.out.find("Results in ");
    // Rocks may leave the small slope, too: that warning speaks of the answer and stands before this one.
    const std::size_t closing = both.out.find("bannwald: done, with ");
    ASSERT_NE(results, std::string::npos) << both.out;
    ASSERT_NE(closing, std::string::npos) << both.out;
    EXPECT_LT(results, closing);
    const std::size_t tree = both.out.find("bannwald: warning: trees.csv", closing);
    ASSERT_NE(tree, std::string::npos) << both.out;
    EXPECT_EQ(both.out.find("bannwald: done, with ", closing + 1), std::string::npos) << both.out;
    // Nothing but warnings and the number of notes stands below.
    std::istringstream below{both.out.substr(closing)};
    for (std::string line; std::getline(below, line);) {
        EXPECT_TRUE(line.starts_with("bannwald: ")) << line;
    }
}

TEST(WarningsOfARun, StandOnTheFirstScreenOfEveryKindOfPage) {
    const SampleProject project;
    project.replace("trees.csv", "1060,2050", "1060,2500");
    const std::string tree = "1 of 3 trees off the terrain";
    for (const char* folder : {"a", "b"}) {
        ASSERT_EQ(
            call(project, "run scenario.ini -q --set release.rocks=200 --out " + std::string{folder}).code,
            0);
    }
    ASSERT_EQ(call(project, "compare a b --quiet --page c.html").code, 0);
    EXPECT_NE(first_screen(project, "c.html").find(tree), std::string::npos)
        << first_screen(project, "c.html");

    project.write("blocks.csv", "return_period_years,zone,diameter_m\n10,1,0.3\n30,1,0.5\n");
    project.replace("scenario.ini", "diameter_m = 0.5\n", "");
    project.replace("scenario.ini", "[targets]", "[hazard]\nblocks = blocks.csv\n[targets]");
    const Outcome hazard = call(project, "run scenario.ini -q --set release.rocks=200");
    ASSERT_EQ(hazard.code, 0) << hazard.err;
    EXPECT_NE(hazard.err.find(tree), std::string::npos) << hazard.err;
    EXPECT_NE(first_screen(project, "out/return_period_10/report.html").find(tree), std::string::npos);
    // Behind answer, map and assumptions, before all tables.
    const std::string map = project.read("out/hazard/report.html");
    EXPECT_NE(map.substr(0, map.find("Targets by level and how often")).find(tree), std::string::npos);
}

TEST(WarningsOfARun, StandOnTheFirstScreenOverYearsAndAlongAProfile) {
    const ForestProject years;
    const std::string leaving = "of the rocks leave the terrain";
    const Outcome decades = call(years, std::string{four_members});
    ASSERT_EQ(decades.code, 0) << decades.err;
    EXPECT_NE(decades.err.find(leaving), std::string::npos) << decades.err;
    EXPECT_NE(first_screen(years, "out/report.html").find(leaving), std::string::npos);

    const SampleProject project;
    ASSERT_EQ(call(project, "init p --quiet --example profile").code, 0);
    const Outcome profile = call(project, "run p/scenario.ini --quiet --set release.rocks=50");
    ASSERT_EQ(profile.code, 0) << profile.err;
    EXPECT_NE(profile.err.find("only 50 rocks"), std::string::npos) << profile.err;
    EXPECT_NE(first_screen(project, "p/out/report.html").find("only 50 rocks"), std::string::npos);
}

TEST(ThePage, SaysWhyNoTreesAreLeft) {
    const SampleProject project;
    project.write("trees.csv", "tree_id,x_m,y_m,species,dbh_cm,height_m\n");
    ASSERT_EQ(call(project, "run scenario.ini --quiet --set release.rocks=200").code, 0);
    const std::string page = project.read("out/report.html");
    EXPECT_NE(page.find("no trees or logs are left: trees.csv list none on the terrain"), std::string::npos);
    EXPECT_EQ(page.find("were given"), std::string::npos);
}

}  // namespace
}  // namespace coupling::mistaken_input_test
