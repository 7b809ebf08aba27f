#include <gtest/gtest.h>

#include <filesystem>

#include "coupling/validation/case_files.hpp"
#include "coupling/validation/write_results.hpp"
#include "tests/runs/program.hpp"

namespace coupling {
namespace {

const std::string even_cases = "--cases '" BANNWALD_SOURCE_DIR "/tests/runs/cases' ";

TEST(Validate, TellsMissesByItsExitCode) {
    const SampleProject project;
    const Outcome misses = call(project, "validate " + even_cases + "--quiet --out misses even_plane");
    EXPECT_EQ(misses.code, 5) << misses.err;
    EXPECT_NE(misses.out.find("missed by strict: mean speed at foot"), std::string::npos) << misses.out;
    EXPECT_NE(misses.out.find("likely cause: the criterion is meant to be missed"), std::string::npos);
    const Outcome meets = call(project, "validate " + even_cases + "--quiet --out meets even_forest");
    EXPECT_EQ(meets.code, 0) << meets.out << meets.err;
}

TEST(Validate, WritesTheSameFilesOnAnyNumberOfThreads) {
    const SampleProject project;
    ASSERT_EQ(call(project, "validate all " + even_cases + "--quiet --threads 1 --out first").code, 5);
    for (const std::string& name : validation::result_names()) {
        EXPECT_GT(std::filesystem::file_size(project.file("first/" + name)), 10U) << name;
    }
    EXPECT_FALSE(std::filesystem::exists(project.file("first/.writing")));
    const Outcome outcome = shell(project, "\"$bannwald\" validate all " + even_cases +
                                               "--quiet --threads 3 --out other; diff -r first other\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST(Validate, RunsEveryShippedCaseWithFewRocks) {
    const SampleProject project;
    for (const validation::CaseFiles& files : validation::shipped_cases()) {
        const Outcome outcome =
            call(project, "validate " + files.name + " --quiet --rocks 20 --out " + files.name);
        EXPECT_TRUE(outcome.code == 0 || outcome.code == 5) << files.name << '\n' << outcome.err;
        EXPECT_TRUE(std::filesystem::exists(project.file(files.name + "/report.html"))) << files.name;
    }
}

TEST(Validate, ListsItsCases) {
    const SampleProject project;
    const Outcome outcome = call(project, "validate --list " + even_cases);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_NE(outcome.out.find("even_plane"), std::string::npos);
    EXPECT_NE(outcome.out.find("even slope of 38 degrees with a stand"), std::string::npos);
}

TEST(Validate, SuggestsTheNearestCase) {
    const SampleProject project;
    const Outcome outcome = call(project, "validate even_plan " + even_cases);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("'even_plane'"), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(project.file("validation-results")));
}

TEST(Validate, TakesASurveyedProfile) {
    const SampleProject project;
    project.write("surveyed.csv", "distance_m,height_m,surface\n0,500,fine_debris\n600,0,\n");
    const Outcome outcome =
        call(project, "validate even_plane " + even_cases + "--quiet --out out --profile surveyed.csv");
    EXPECT_EQ(outcome.code, 5) << outcome.err;
    EXPECT_NE(outcome.out.find("note: profile.csv replaced by surveyed.csv"), std::string::npos)
        << outcome.out;
    EXPECT_EQ(call(project, "validate all " + even_cases + "--profile surveyed.csv").code, 2);
    EXPECT_EQ(call(project, "validate even_plane " + even_cases + "--profile missing.csv").code, 3);
}

TEST(Validate, TellsFileAndLineOfABrokenCase) {
    const SampleProject project;
    const Outcome outcome =
        shell(project, "cp -r '" BANNWALD_SOURCE_DIR
                       "/tests/runs/cases' mine\n"
                       "echo 'mean_speed,1,2,independent,x,' >> mine/even_plane/criteria.csv\n"
                       "\"$bannwald\" validate even_plane --cases mine\n");
    EXPECT_EQ(outcome.code, 4);
    EXPECT_NE(outcome.err.find("mine/even_plane/criteria.csv:5:1: found 'mean_speed'"), std::string::npos)
        << outcome.err;
}

TEST(Validate, LeavesNothingWhenInterrupted) {
    const SampleProject project;
    const Outcome outcome = shell(project, "\"$bannwald\" validate even_plane " + even_cases +
                                               "--quiet --rocks 5000000 --out mine &\n"
                                               "sleep 0.5; kill -TERM $!; wait $!\n");
    EXPECT_EQ(outcome.code, 75) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(project.file("mine")));
}

TEST(Validate, ReplacesOnlyItsOwnResults) {
    const SampleProject project;
    const std::string command = "validate even_forest --rocks 10 --quiet " + even_cases;
    EXPECT_NE(call(project, command + "--out mine").code, 2);
    EXPECT_EQ(call(project, command + "--out mine").code, 2);
    EXPECT_NE(call(project, command + "--out mine --overwrite").code, 2);
    ASSERT_EQ(shell(project, "mkdir theirs && echo 'a page of somebody else' > theirs/report.html\n").code,
              0);
    EXPECT_EQ(call(project, command + "--out theirs --overwrite").code, 2);
    EXPECT_EQ(project.read("theirs/report.html"), "a page of somebody else\n");
    EXPECT_FALSE(std::filesystem::exists(project.file("theirs/verdicts.csv")));
}

}  // namespace
}  // namespace coupling
