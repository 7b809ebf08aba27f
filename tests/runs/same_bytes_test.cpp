#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/runs/program.hpp"

namespace coupling {
namespace {

/// Runs into a folder of its own and compares all files with those of the first run.
Outcome run_and_compare(const SampleProject& project, const std::string& arguments, const std::string& folder) {
    return shell(project, "\"$bannwald\" run scenario.ini --quiet " + arguments + " --out " + folder +
                              " && diff -r first " + folder + "\n");
}

TEST(Results, AreTheSameBytesOnAnyNumberOfThreads) {
    const SampleProject project;
    const std::string rocks = "--set release.rocks=20000 ";
    ASSERT_EQ(call(project, "run scenario.ini --quiet --threads 1 " + rocks + "--out first").code, 0);
    ASSERT_TRUE(std::filesystem::exists(project.file("first/tables/rocks.csv")));
    for (const std::string threads : {"2", "7"}) {
        const Outcome outcome = run_and_compare(project, rocks + "--threads " + threads, "with_" + threads);
        EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    }
}

TEST(Results, AreTheSameBytesWhereBrokenTreesFall) {
    const SampleProject project;
    const std::string rocks = "--set release.rocks=5000 --set tree_impact.remove_broken=yes ";
    ASSERT_EQ(call(project, "run scenario.ini --quiet --threads 1 " + rocks + "--out first").code, 0);
    const Outcome outcome = run_and_compare(project, rocks + "--threads 3", "with_3");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST(Results, ChangeWithTheSeed) {
    const SampleProject project;
    ASSERT_EQ(call(project, "run scenario.ini --quiet --out first").code, 0);
    EXPECT_NE(run_and_compare(project, "--seed 77", "other").code, 0);
}

}  // namespace
}  // namespace coupling
