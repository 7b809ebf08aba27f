#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "tests/runs/motion_models.hpp"
#include "tests/runs/program.hpp"

namespace coupling::same_bytes_test {
namespace {

/// Runs into a folder of its own and compares all files with those of the first run.
Outcome run_and_compare(const SampleProject& project, const std::string& arguments,
                        const std::string& folder) {
    return shell(project, "\"$bannwald\" run scenario.ini --quiet " + arguments + " --out " + folder +
                              " && diff -r first " + folder + "\n");
}

/// What holds for results holds under every motion model.
class ResultsOfModel : public ::testing::TestWithParam<std::string> {
protected:
    [[nodiscard]] static std::string motion() { return motion_settings(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Motion, ResultsOfModel, ::testing::ValuesIn(motion_model_names()),
                         [](const auto& model) { return model.param; });

TEST_P(ResultsOfModel, AreTheSameBytesOnAnyNumberOfThreads) {
    const SampleProject project;
    const std::string rocks = motion() + rocks_for(GetParam(), 20000);
    ASSERT_EQ(call(project, "run scenario.ini --quiet --threads 1 " + rocks + "--out first").code, 0);
    ASSERT_TRUE(std::filesystem::exists(project.file("first/tables/rocks.csv")));
    for (const std::string threads : {"2", "7"}) {
        const Outcome outcome = run_and_compare(project, rocks + "--threads " + threads, "with_" + threads);
        EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    }
}

TEST_P(ResultsOfModel, AreTheSameBytesWhereBrokenTreesFall) {
    const SampleProject project;
    const std::string rocks = motion() + rocks_for(GetParam(), 5000) + "--set tree_impact.remove_broken=yes ";
    ASSERT_EQ(call(project, "run scenario.ini --quiet --threads 1 " + rocks + "--out first").code, 0);
    const Outcome outcome = run_and_compare(project, rocks + "--threads 3", "with_3");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST_P(ResultsOfModel, AreTheSameBytesFromSourcesWithRocksOfTheirOwn) {
    const SampleProject project;
    project.write("cliffs.csv",
                  "zone,wkt,blocks,speed_mps,azimuth_deg,fall_height_m,mass_t,density_kgpm3\n"
                  "1,\"LINESTRING (1020 2030, 1022 2045, 1020 2060)\",60,5,100,,,\n"
                  "2,\"LINESTRING (1030 2030, 1030 2040)\",7,,,10,1.5,2600\n"
                  "3,\"LINESTRING (1030 2060, 1030 2070)\",,,,,0.1,\n");
    project.replace("scenario.ini", "source = source.asc", "source_shapes = cliffs.csv\nrocks = 30");
    ASSERT_EQ(call(project, "run scenario.ini --quiet --threads 1 " + motion() + "--out first").code, 0);
    const Outcome outcome = run_and_compare(project, motion() + "--threads 5", "with_5");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    // rock, cover, zone, ...: a line for each of 97 rocks with forest and on the bare slope
    const std::string rocks = project.read("first/tables/rocks.csv");
    EXPECT_EQ(std::count(rocks.begin(), rocks.end(), '\n'), 1 + 2 * 97);
}

/// Logs across the slope of the sample project.
void add_logs(const SampleProject& project) {
    project.write("logs.csv",
                  "log_id,x1_m,y1_m,x2_m,y2_m,species,dbh_cm,clearance_m,anchored\n"
                  "a,1060,2030,1062,2065,PIAB,40,0,yes\nb,1080,2030,1078,2070,ABAL,15,0.2,no\n");
    project.replace("scenario.ini", "file = trees.csv\n", "file = trees.csv\nlogs = logs.csv\n");
}

TEST_P(ResultsOfModel, AreTheSameBytesWithLogsThatMayBreak) {
    const SampleProject project;
    add_logs(project);
    for (const std::string remove : {"no", "yes"}) {
        const std::string rocks = motion() + "--overwrite " + rocks_for(GetParam(), 5000) +
                                  "--set tree_impact.remove_broken=" + remove + " ";
        ASSERT_EQ(call(project, "run scenario.ini --quiet --threads 1 " + rocks + "--out first").code, 0);
        const Outcome outcome = run_and_compare(project, rocks + "--threads 3", "with_3");
        EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
        EXPECT_NE(project.read("first/tables/rocks.csv").find(",log,"), std::string::npos);
        EXPECT_NE(project.read("first/tables/log_hits.csv").find(",a,"), std::string::npos);
    }
}

TEST(Results, TellTheEffectOfLogsWithoutTrees) {
    const SampleProject project;
    add_logs(project);
    const Outcome outcome =
        call(project, "run scenario.ini --quiet --set trees.file= --set release.rocks=2000 --out first");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(std::filesystem::exists(project.file("first/tables/logs.csv")));
    EXPECT_TRUE(std::filesystem::exists(project.file("first/tables/protection.csv")));
    EXPECT_FALSE(std::filesystem::exists(project.file("first/tables/stems.csv")));
    EXPECT_NE(project.read("first/report.html").find("Stopped at a lying log"), std::string::npos);
}

TEST(Results, ChangeWithTheMotionModel) {
    const SampleProject project;
    ASSERT_EQ(call(project, "run scenario.ini --quiet --set rockfall.motion=picus --out first").code, 0);
    EXPECT_NE(run_and_compare(project, "", "default").code, 0);  // the page says whether it was set
    EXPECT_EQ(project.read("default/tables/rocks.csv"), project.read("first/tables/rocks.csv"));
    EXPECT_NE(run_and_compare(project, "--set rockfall.motion=pir3d", "other").code, 0);
    EXPECT_NE(project.read("other/tables/rocks.csv"), project.read("first/tables/rocks.csv"));
    EXPECT_NE(project.read("other/tables/tree_hits.csv").find("\n"), std::string::npos);
}

TEST(Results, ChangeWithTheSeed) {
    const SampleProject project;
    ASSERT_EQ(call(project, "run scenario.ini --quiet --out first").code, 0);
    EXPECT_NE(run_and_compare(project, "--seed 77", "other").code, 0);
}

}  // namespace
}  // namespace coupling::same_bytes_test
