// Runs along a profile through the program itself.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>

#include "tests/coupling/assessments/profile/profile_project.hpp"
#include "tests/coupling/results/markup_checks.hpp"
#include "tests/runs/program.hpp"

namespace coupling::profile_test {
namespace {

namespace fs = std::filesystem;

struct ProfileProject : SampleProject {
    ProfileProject() { make_profile_project(*this); }
};

std::size_t lines_of(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(ProfileRun, WritesWhatItPromises) {
    const ProfileProject project;
    const Outcome outcome = call(project, "run scenario.ini --verbose");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("500 rocks along a profile of 300 m"), std::string::npos) << outcome.out;
    for (const std::string file : {"report.html", "summary.json", "tables/rocks.csv",
                                   "tables/jumps_by_segment.csv", "tables/run_out.csv", "tables/stations.csv",
                                   "tables/envelope.csv", "tables/paths.csv", ".bannwald"}) {
        EXPECT_TRUE(fs::exists(project.file("out") / file)) << file;
        if (file != ".bannwald") {
            EXPECT_NE(outcome.out.find(file), std::string::npos) << file;
        }
    }
    EXPECT_FALSE(fs::exists(project.file("out/parts")) || fs::exists(project.file("out/.writing")));
    EXPECT_EQ(lines_of(project.read("out/tables/rocks.csv")), 501U);
    EXPECT_EQ(lines_of(project.read("out/tables/stations.csv")), 3U);
    EXPECT_EQ(text_checks::markup_fault(project.read("out/report.html")), "");
    EXPECT_NE(project.read("out/summary.json").find("\"stations\""), std::string::npos);
}

TEST(ProfileRun, DrawsEveryChartWithAxesAndNames) {
    const ProfileProject project;
    ASSERT_EQ(call(project, "run scenario.ini --quiet").code, 0);
    const std::string page = text_checks::without_scripts(project.read("out/report.html"));
    for (const char* text :
         {"The profile at true vertical scale", "Distance in plan, m", "Height, m",
          "% of rocks ending beyond", "Length along the slope, m", "Jump length, m", "Energy, kJ",
          "Energy at the station “road”", "Stations: 1 road, 2 foot.", "95 % interval", "shortest to longest",
          "95 % of them stay below", "forest road"}) {
        EXPECT_NE(page.find(text), std::string::npos) << text;
    }
    EXPECT_EQ(page.find(" d=\"\""), std::string::npos) << "an empty path";
    EXPECT_FALSE(std::regex_search(page, std::regex{"\\bnan\\b"}));
    for (const char* outside : {"http:", "https:", "<link", "@import"}) {
        EXPECT_EQ(page.find(outside), std::string::npos) << outside;
    }
}

TEST(ProfileRun, GivesTheSameBytesOnAnyNumberOfThreads) {
    const ProfileProject project;
    ASSERT_EQ(call(project, "run scenario.ini --quiet --threads 1 --out first").code, 0);
    for (const std::string threads : {"2", "5"}) {
        const Outcome outcome =
            shell(project, "\"$bannwald\" run scenario.ini --quiet --threads " + threads + " --out with_" +
                               threads + " && diff -r first with_" + threads + "\n");
        EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    }
}

TEST(ProfileRun, ReplacesItsResultsOnlyIfAsked) {
    const ProfileProject project;
    ASSERT_EQ(call(project, "run scenario.ini --quiet").code, 0);
    EXPECT_EQ(call(project, "run scenario.ini --quiet").code, 2);
    EXPECT_EQ(call(project, "run scenario.ini --quiet --overwrite --set output.rock_table=no").code, 0);
    EXPECT_FALSE(fs::exists(project.file("out/tables/rocks.csv")));
    EXPECT_TRUE(fs::exists(project.file("out/tables/run_out.csv")));
}

TEST(ProfileRun, RunsWithoutStationsPathsAndJumps) {
    const ProfileProject project;
    project.replace("scenario.ini", "stations = stations.csv\n", "");
    // Rolls from the start, on ground too flat to go on.
    project.write("profile.csv", "distance_m,height_m,surface\n0,10,road\n300,10,\n");
    const Outcome outcome =
        call(project,
             "run scenario.ini --set output.sample_paths=0 --set release.start_height_m=0 "
             "--set release.start_speed_mps=0.5 --set release.rocks=20");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(text_checks::markup_fault(project.read("out/report.html")), "");
    EXPECT_FALSE(std::regex_search(text_checks::without_scripts(project.read("out/report.html")),
                                   std::regex{"\\bnan\\b"}));
    EXPECT_NE(project.read("out/tables/rocks.csv").find(",at_rest,0.00,10.00,"), std::string::npos);
}

TEST(ProfileRun, GoesTowardsLargerDistanceOnFlatGround) {
    const ProfileProject project;
    project.write("profile.csv", "distance_m,height_m,surface\n0,60,road\n30,60,road\n100,0,road\n300,0,\n");
    ASSERT_EQ(call(project,
                   "run scenario.ini --quiet --set profile.start_m=26 --set release.start_speed_mps=8 "
                   "--set release.rocks=200")
                  .code,
              0);
    const std::string rocks = project.read("out/tables/run_out.csv");
    // Nobody leaves over the upper end.
    EXPECT_NE(rocks.find("\n25.00,200,100.0000,"), std::string::npos) << rocks.substr(0, 400);
}

TEST(ProfileRun, IsAnExampleWithoutDoubts) {
    const SampleProject project;
    const Outcome outcome = shell(project,
                                  "\"$bannwald\" init steg --example profile --quiet && "
                                  "\"$bannwald\" check steg/scenario.ini --set run.strict_inputs=yes && "
                                  "\"$bannwald\" run steg/scenario.ini --set release.rocks=300\n");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("300 rocks along a profile of 500 m"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.err.find("warning"), std::string::npos) << outcome.err;
    for (const std::string file : {"README.md", "profile.csv", "scenario.ini", "stations.csv"}) {
        const std::string text = project.read("steg/" + file);
        EXPECT_TRUE(text.find("ynthetic") != std::string::npos || text.find("SYNTHETIC") != std::string::npos)
            << file;
    }
}

TEST(ProfileCheck, TellsWhatTheRunWillTake) {
    const ProfileProject project;
    const Outcome outcome = call(project, "check scenario.ini");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    for (const char* text : {"5 corners from 0 m to 300 m", "drop 162.5 m", "rock; soil; forest road",
                             "road, foot", "500 in two dimensions"}) {
        EXPECT_NE(outcome.out.find(text), std::string::npos) << text << '\n' << outcome.out;
    }
    EXPECT_FALSE(fs::exists(project.file("out")));
}

}  // namespace
}  // namespace coupling::profile_test
