#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/runs/program.hpp"

namespace coupling::output_folder_test {
namespace {

namespace fs = std::filesystem;

TEST(OutputFolder, NeverTouchesWhatNoRunWrote) {
    const SampleProject project;
    fs::create_directories(project.file("mine/tables"));
    project.write("mine/tables/trees.csv", "my own work\n");
    for (const std::string overwrite : {"", " --overwrite"}) {
        const Outcome outcome = call(project, "run scenario.ini --quiet --out mine" + overwrite);
        EXPECT_EQ(outcome.code, 2) << outcome.err;
        EXPECT_EQ(project.read("mine/tables/trees.csv"), "my own work\n");
    }
}

TEST(OutputFolder, HoldsNothingOfARunThatWasKilledWhileItWrote) {
    const SampleProject project;
    ASSERT_EQ(call(project, "run scenario.ini --quiet").code, 0);
    // What a kill in the middle of writing leaves: no results yet, half of them in the staging folder.
    fs::remove(project.file("out/summary.json"));
    fs::create_directories(project.file("out/.writing/rasters/forest"));
    project.write("out/.writing/rasters/forest/E_95.asc", "half a map\n");
    ASSERT_EQ(call(project, "run scenario.ini --quiet --overwrite --set trees.file=").code, 0);
    EXPECT_FALSE(fs::exists(project.file("out/rasters/forest/E_95.asc")));
    EXPECT_FALSE(fs::exists(project.file("out/.writing")));
}

TEST(ProgramOverResults, RefusesUnlessToldToOverwrite) {
    const SampleProject project;
    ASSERT_EQ(call(project, "run scenario.ini --quiet").code, 0);
    const Outcome again = call(project, "run scenario.ini --quiet");
    EXPECT_EQ(again.code, 2) << again.err;
    EXPECT_NE(again.err.find("--overwrite"), std::string::npos) << again.err;
    EXPECT_EQ(call(project, "run scenario.ini --quiet --overwrite").code, 0);
}

}  // namespace
}  // namespace coupling::output_folder_test
