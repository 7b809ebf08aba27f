#include "coupling/inputs/forest/log_input.hpp"

#include <gtest/gtest.h>

#include "tests/coupling/inputs/opened.hpp"

namespace coupling::log_input_test {
namespace {

using config::ExitCode;

/// What comes of the sample project with this list of logs.
Opened with_logs(const std::string& text, const std::vector<std::string>& overrides = {}) {
    const SampleProject project;
    project.write("logs.csv", text);
    project.replace("scenario.ini", "file = trees.csv\n", "file = trees.csv\nlogs = logs.csv\n");
    return open(project, overrides);
}

constexpr const char* by_ends = "log_id,x1_m,y1_m,x2_m,y2_m,species,dbh_cm\n";

TEST(Logs, AreReadFromTheirEnds) {
    const Opened opened = with_logs(
        "log_id,x1_m,y1_m,x2_m,y2_m,species,diameter1_cm,diameter2_cm,clearance_m,strength,anchored\n"
        "a,1060,2050,1060,2062,piab,40,25,0.3,0.8,yes\nb,1070,2050,1075,2050,Fagus sylvatica,30,30,,,\n");
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_TRUE(opened.warnings.empty());
    ASSERT_EQ(opened.site->logs.size(), 2U);
    const LogRecord& a = opened.site->logs[0];
    EXPECT_EQ(a.id, "a");
    EXPECT_EQ(a.species, "PIAB");
    EXPECT_EQ(a.log.y2_m, 2062.0);
    EXPECT_EQ(a.log.diameter1_cm, 40.0);
    EXPECT_EQ(a.log.diameter2_cm, 25.0);
    EXPECT_EQ(a.log.clearance_m, 0.3);
    EXPECT_EQ(a.log.strength, 0.8);
    EXPECT_EQ(a.log.fracture_energy, 0.9);
    EXPECT_TRUE(a.log.supported);
    const rockfall::Log& b = opened.site->logs[1].log;
    EXPECT_EQ(b.clearance_m, 0.0);
    EXPECT_EQ(b.strength, 1.0);
    EXPECT_FALSE(b.supported);
    EXPECT_EQ(opened.site->lying_logs().size(), 2U);
}

TEST(Logs, AreReadFromOneEndLengthAndAzimuth) {
    const Opened opened = with_logs(
        "x_m,y_m,length_m,azimuth_deg,species,dbh_cm\n1060,2050,10,90,ABAL,30\n1060,2050,10,180,ABAL,30\n");
    ASSERT_TRUE(opened.site) << opened.errors;
    const rockfall::Log& east = opened.site->logs[0].log;
    EXPECT_NEAR(east.x2_m, 1070.0, 1e-9);
    EXPECT_NEAR(east.y2_m, 2050.0, 1e-9);
    EXPECT_NEAR(opened.site->logs[1].log.y2_m, 2040.0, 1e-9);
    EXPECT_EQ(opened.site->logs[1].id, "2");
}

TEST(Logs, NeedNoTrees) {
    const Opened opened =
        with_logs(std::string{by_ends} + "a,1060,2050,1060,2060,ABAL,30\n", {"trees.file="});
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_TRUE(opened.site->trees.empty());
    EXPECT_EQ(opened.site->logs.size(), 1U);
}

TEST(Logs, AreRefusedWithEveryFaultInTheOrderOfLines) {
    const Opened opened = with_logs(
        "log_id,x1_m,y1_m,x2_m,y2_m,species,dbh_cm\n"
        "a,1060,2050,1060,2050,ABAL,30\n"
        "b,1060,2050,1060,2060,ABBL,-3\n");
    EXPECT_EQ(opened.code, ExitCode::data);
    EXPECT_EQ(
        opened.errors,
        "logs.csv:2:13: found a log of 0 m, expected a length in (0, 150] m\n"
        "logs.csv:3:23: found species 'ABBL', expected a code or Latin name of the species table (ABAL?)\n"
        "logs.csv:3:28: found dbh_cm '-3', expected a number in (0, 500]");
}

TEST(Logs, WithoutTheirColumnsAreRefused) {
    const std::string by_ends_errors = with_logs("x1_m,y1_m,x2_m,y2_m,species\n").errors;
    EXPECT_NE(
        by_ends_errors.find("logs.csv: no column 'diameter1_cm' among x1_m, y1_m, x2_m, y2_m, species;"),
        std::string::npos)
        << by_ends_errors;
    EXPECT_NE(by_ends_errors.find("\nlogs.csv: no column 'diameter2_cm' among "), std::string::npos);
    const std::string by_middle_errors = with_logs("x_m,y_m,length_m,species,dbh_cm\n").errors;
    EXPECT_TRUE(by_middle_errors.starts_with("logs.csv: no column 'azimuth_deg' among ")) << by_middle_errors;
}

TEST(Logs, OutsideTheTerrainAreLeftOutAndCounted) {
    const std::string text =
        std::string{by_ends} + "a,1060,2050,1060,2060,ABAL,30\nb,1060,2050,1060,2150,ABAL,30\n";
    const Opened opened = with_logs(text);
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.site->logs.size(), 1U);
    EXPECT_EQ(opened.warnings,
              std::vector<std::string>{
                  "logs.csv: found 1 of 2 logs off the terrain, such as log 'b' (x 1060, y 2050); left out, "
                  "expected logs on the terrain; correct their coordinates unless they stand beyond its "
                  "border"});
    EXPECT_EQ(with_logs(text, {"run.strict_inputs=yes"}).code, ExitCode::data);
}

TEST(Logs, WithSwappedAxesAreRefusedUntilTheSettingSwapsThem) {
    for (const std::string& text : {std::string{by_ends} + "a,2050,1060,2060,1065,ABAL,30\n",
                                    std::string{"log_id,x_m,y_m,length_m,azimuth_deg,species,dbh_cm\n"} +
                                        "a,2050,1060,8,90,ABAL,30\n"}) {
        const Opened swapped = with_logs(text);
        EXPECT_EQ(swapped.code, ExitCode::data);
        EXPECT_NE(swapped.errors.find("1 of 1 log off the terrain: x and y look swapped"), std::string::npos)
            << swapped.errors;
        const Opened right = with_logs(text, {"trees.swap_logs_xy=yes"});
        ASSERT_TRUE(right.site) << right.errors;
        ASSERT_EQ(right.site->logs.size(), 1U);
        EXPECT_EQ(right.site->logs[0].log.x1_m, 1060.0);
        EXPECT_GT(right.site->logs[0].log.x2_m, 1060.0);
    }
}

TEST(Logs, InAnotherUnitAreRefused) {
    EXPECT_EQ(
        with_logs(std::string{by_ends} + "a,1060,2050,1060,2060,ABAL,0.3\n").errors,
        "logs.csv: found a median dbh_cm of 0.3, which looks like metres, expected centimetres; multiply "
        "the column dbh_cm by 100");
}

TEST(Logs, OfOneIdentityOrNoneAreDoubted) {
    const Opened twice =
        with_logs(std::string{by_ends} + "a,1060,2050,1060,2060,ABAL,30\na,1065,2050,1065,2060,ABAL,30\n");
    EXPECT_EQ(twice.warnings,
              std::vector<std::string>{"logs.csv: found 1 log_id used more than once, such as 'a', "
                                       "expected one log_id for each log"});
    EXPECT_EQ(with_logs(by_ends).warnings,
              std::vector<std::string>{"logs.csv: found no logs, expected at least one, or no trees.logs"});
}

TEST(Logs, OfAGrowingForestAreItsOwn) {
    const Opened opened =
        with_logs(std::string{by_ends} + "a,1060,2050,1060,2060,ABAL,30\n", {"run.years=10"});
    EXPECT_EQ(opened.code, ExitCode::settings);
    EXPECT_NE(opened.errors.find("trees.logs beside run.years above 0"), std::string::npos) << opened.errors;
}

TEST(Logs, MeanNothingAlongAProfile) {
    const SampleProject project;
    project.write("profile.csv", "distance_m,height_m,surface\n0,100,medium_scree\n100,50,\n");
    project.write("scenario.ini", "[terrain]\nprofile = profile.csv\n[trees]\nlogs = logs.csv\n");
    const Opened opened = open(project);
    EXPECT_EQ(opened.code, ExitCode::settings);
    EXPECT_NE(opened.errors.find("trees.logs"), std::string::npos) << opened.errors;
}

}  // namespace
}  // namespace coupling::log_input_test
