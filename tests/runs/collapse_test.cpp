// `bannwald collapse` from end to end, on a small SYNTHETIC cliff.

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "config/table/table.hpp"
#include "tests/runs/program.hpp"

namespace coupling::collapse_runs_test {
namespace {

/// Few large blocks for a short time.
const std::string few =
    "collapse p/scenario.ini --quiet --set collapse.duration_s=0.2 --set collapse.frame_s=0.05 "
    "--set collapse.depth_m=8 --set collapse.least_block_m=2 --set collapse.settle_s=0.1 --out ";

config::Table table_of(const SampleProject& project, const std::string& file) {
    std::istringstream in{project.read(file)};
    return config::Table::read(in, file);
}

class CollapseRuns : public ::testing::Test {
protected:
    void SetUp() override { ASSERT_EQ(call(project, "init p --example collapse-small --quiet").code, 0); }
    SampleProject project;
};

TEST_F(CollapseRuns, WritesTheSameBytesOnAnyNumberOfThreads) {
    ASSERT_EQ(call(project, few + "one --threads 1").code, 0);
    for (const char* threads : {"2", "4"}) {
        const std::string out = std::string{"on_"} + threads;
        ASSERT_EQ(call(project, few + out + " --threads " + threads).code, 0);
        const auto differences = shell(project, "diff -r one " + out + "\n");
        EXPECT_EQ(differences.code, 0) << threads << " threads: " << differences.out;
    }
}

TEST_F(CollapseRuns, GoesOnAfterItWasKilledWithTheSameBytes) {
    ASSERT_EQ(call(project, few + "whole").code, 0);
    // Killed once the state of the first frame is on the disk: there is no time to tidy up.
    EXPECT_EQ(shell(project, interrupted_once("parts/parts/mass.part", few + "parts", "KILL")).code, 137);
    ASSERT_EQ(call(project, few + "parts").code, 0);
    const auto differences = shell(project, "diff -r whole parts\n");
    EXPECT_EQ(differences.code, 0) << differences.out;
}

TEST_F(CollapseRuns, ClosesItsLedger) {
    ASSERT_EQ(call(project, few + "out").code, 0);
    const config::Table table = table_of(project, "out/tables/energies.csv");
    ASSERT_GE(table.rows(), 4U);
    config::Problems problems;
    double fracture = 0.0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        EXPECT_LE(std::abs(table.number(row, "residual_percent", {}, problems).value_or(100.0)), 2.0);
        const double now = table.number(row, "fracture_mj", {}, problems).value_or(-1.0);
        EXPECT_GE(now, fracture);
        fracture = now;
    }
    EXPECT_LT(table.number(table.rows() - 1, "gravity_mj", {}, problems).value_or(0.0), 0.0);
}

TEST_F(CollapseRuns, GoesOnAfterAnInterruptionWithTheSameBytes) {
    ASSERT_EQ(call(project, few + "whole").code, 0);
    // A state on the disk comes with the interruption; at once there may be none yet, and the run begins
    // again.
    EXPECT_EQ(shell(project, interrupted_at_once(few + "parts")).code, 75);
    ASSERT_EQ(call(project, few + "parts").code, 0);
    EXPECT_EQ(project.read("whole/tables/energies.csv"), project.read("parts/tables/energies.csv"));
    EXPECT_EQ(project.read("whole/tables/blocks.csv"), project.read("parts/tables/blocks.csv"));
}

TEST_F(CollapseRuns, CheckTellsBlocksMemoryAndTime) {
    const auto result = call(project, "check p/scenario.ini");
    EXPECT_EQ(result.code, 0);
    for (const char* word : {"blocks", "bonds", "steps", "memory", "time"}) {
        EXPECT_NE(result.out.find(word), std::string::npos) << word;
    }
}

TEST_F(CollapseRuns, WritesItsPageInTheLanguageOfTheScenario) {
    ASSERT_EQ(call(project, few + "german --set report.language=de").code, 0);
    const std::string page = project.read("german/report.html");
    EXPECT_NE(page.find("<html lang=\"de\""), std::string::npos);
    EXPECT_NE(page.find("Eine Felsmasse zerf"), std::string::npos);
}

TEST_F(CollapseRuns, IsTheCommandThatRunNamesForItsScenario) {
    const auto outcome = call(project, "run p/scenario.ini");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("bannwald collapse p/scenario.ini"), std::string::npos) << outcome.err;
}

TEST_F(CollapseRuns, RefusesWhatCannotBe) {
    project.write("p/no_spacing.csv", "name,dip_deg,dip_direction_deg\na,40,90\n");
    const auto spacing = call(project, "check p/scenario.ini --set collapse.joint_sets=no_spacing.csv");
    EXPECT_EQ(spacing.code, 4);
    EXPECT_NE(spacing.err.find("spacing_m"), std::string::npos) << spacing.err;

    project.write("p/weak.csv", "name,dip_deg,dip_direction_deg,spacing_m,tensile_mpa\na,40,90,3,-1\n");
    const auto strength = call(project, "check p/scenario.ini --set collapse.joint_sets=weak.csv");
    EXPECT_EQ(strength.code, 4);
    EXPECT_NE(strength.err.find("weak.csv:2"), std::string::npos) << strength.err;
    EXPECT_EQ(call(project, "check p/scenario.ini --set collapse.shear_mpa=-1").code, 2);

    const std::string corners =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
        "element face FACES\nproperty list uchar int vertex_indices\nend_header\n1060 2060 DOWN\n1068 2060 "
        "DOWN\n"
        "1060 2068 DOWN\n1060 2060 TOP\n";
    const auto mesh = [&](const std::string& faces, const std::string& count, const std::string& down,
                          const std::string& top) {
        std::string text = corners + faces;
        for (const auto& [word, value] :
             {std::pair<std::string, std::string>{"FACES", count}, {"DOWN", down}, {"TOP", top}}) {
            for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word)) {
                text.replace(at, word.size(), value);
            }
        }
        return text;
    };
    const std::string closed = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
    const std::string use = " --set collapse.source= --set collapse.mesh=body.ply";
    project.write("p/body.ply", mesh(closed.substr(0, 24), "3", "1080", "1110"));
    const auto open = call(project, "check p/scenario.ini" + use);
    EXPECT_EQ(open.code, 4);
    EXPECT_NE(open.err.find("open surface"), std::string::npos) << open.err;

    project.write("p/body.ply", mesh(closed, "4", "900", "930"));
    const auto below = call(project, "check p/scenario.ini" + use);
    EXPECT_EQ(below.code, 4);
    EXPECT_NE(below.err.find("under the terrain"), std::string::npos) << below.err;
}

}  // namespace
}  // namespace coupling::collapse_runs_test
