#include "coupling/inputs/forest/log_input.hpp"

#include <gtest/gtest.h>

#include "tests/coupling/inputs/opened.hpp"

namespace coupling::log_input_test {
namespace {

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

TEST(Logs, WithSwappedAxesAreRefusedUntilTheSettingSwapsThem) {
    for (const std::string& text : {std::string{by_ends} + "a,2050,1060,2060,1065,ABAL,30\n",
                                    std::string{"log_id,x_m,y_m,length_m,azimuth_deg,species,dbh_cm\n"} +
                                        "a,2050,1060,8,90,ABAL,30\n"}) {
        EXPECT_EQ(with_logs(text).code, config::ExitCode::data);
        const Opened right = with_logs(text, {"trees.swap_logs_xy=yes"});
        ASSERT_TRUE(right.site) << right.errors;
        ASSERT_EQ(right.site->logs.size(), 1U);
        EXPECT_EQ(right.site->logs[0].log.x1_m, 1060.0);
        EXPECT_GT(right.site->logs[0].log.x2_m, 1060.0);
    }
}

}  // namespace
}  // namespace coupling::log_input_test
