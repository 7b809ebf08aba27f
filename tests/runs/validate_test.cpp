#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "config/table/table.hpp"
#include "tests/runs/program.hpp"
#include "validation/engine/case/case_files.hpp"
#include "validation/engine/write_results.hpp"

namespace coupling::validate_test {
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

/// Forests of 10 years instead of 400 or 600, one tree a cell, the ages that criteria speak of.
const std::map<std::string, std::string> few_years{
    {"forest_belts",
     " --set run.years=10 --set years.from_year=10 --set terrain.plane_width_m=30 "
     "--set terrain.plane_length_m=30 --set run.replicates=1"},
    {"forest_beetles",
     " --set run.replicates=1 --set run.years=3 --set terrain.plane_width_m=30 "
     "--set terrain.plane_length_m=30"},
    {"forest_regeneration",
     " --set run.replicates=1 --set stands.spin_up_years=0 --set run.years=6 --set output.tree_list_years=6"},
    {"forest_dry",
     " --set run.years=10 --set years.from_year=10 --set terrain.plane_width_m=30 "
     "--set terrain.plane_length_m=30 --set run.replicates=1"},
    {"forest_old",
     " --set run.years=10 --set years.from_year=10 --set terrain.plane_width_m=30 "
     "--set terrain.plane_length_m=30 --set run.replicates=1"},
    {"forest_disturbed",
     " --set run.years=10 --set years.from_year=10 --set terrain.plane_width_m=30 "
     "--set terrain.plane_length_m=30 --set run.replicates=1 --set disturbance.first_year=3"},
    {"tschamut2014", " --set rigid.longest_s=1"},
    {"collapse", " --set collapse.duration_s=0.1 --set collapse.frame_s=0.05 --set collapse.settle_s=0"},
    {"g318", " --set rigid.longest_s=1 --set release.rocks=2"},
    {"g318_field", " --set rigid.longest_s=1 --set release.rocks=2"},
    {"g318_site", " --set rigid.longest_s=1 --set release.rocks=2"},
    {"reach_angles", " --set rigid.longest_s=1 --set release.rocks=40"},
    {"forest_demography", " --set run.replicates=1 --set run.years=1 --set years.from_year=1"},
    {"forest_hauersteig", " --set run.replicates=1 --set run.years=10"},
    {"forest_yield",
     " --set run.years=10 --set output.tree_list_years=10 --set terrain.plane_width_m=30 "
     "--set terrain.plane_length_m=30"}};

class ShippedCase : public ::testing::TestWithParam<std::string> {};

TEST_P(ShippedCase, RunsWithFewRocks) {
    const SampleProject project;
    const Outcome outcome =
        call(project, "validate " + GetParam() + " --quiet --rocks 20 --out case" +
                          (few_years.contains(GetParam()) ? few_years.at(GetParam()) : ""));
    EXPECT_TRUE(outcome.code == 0 || outcome.code == 5) << outcome.err;
    EXPECT_TRUE(std::filesystem::exists(project.file("case/report.html")));
    if (GetParam().starts_with("forest_")) {
        EXPECT_FALSE(std::filesystem::exists(project.file("case/run_out.csv"))) << "no rock falls";
    }
}

/// Cases with a number of rocks of their own, which --rocks does not lower, or all others.
std::vector<std::string> names_of_shipped_cases(bool rocks_of_their_own) {
    std::vector<std::string> names;
    for (const validation::CaseFiles& files : validation::shipped_cases()) {
        if ((files.name == "tschamut2014") == rocks_of_their_own) {
            names.push_back(files.name);
        }
    }
    return names;
}
INSTANTIATE_TEST_SUITE_P(Validate, ShippedCase, ::testing::ValuesIn(names_of_shipped_cases(false)),
                         [](const auto& one) { return one.param; });
INSTANTIATE_TEST_SUITE_P(LongValidate, ShippedCase, ::testing::ValuesIn(names_of_shipped_cases(true)),
                         [](const auto& one) { return one.param; });

config::Table result_table(const SampleProject& project, const std::string& name) {
    std::ifstream in{project.file(name)};
    return config::Table::read(in, name);
}

TEST(Validate, HoldsTheFiguresThatTheReadmeBuildsOn) {
    // 1000 rocks. Limits: the criteria of the cases, widened by four standard errors of 1000 rocks (spread
    // between rocks: 3 m/s for the largest speed, 2.2 tree hits; shares binomial), and the wider of strict
    // and default.
    const SampleProject project;
    ASSERT_EQ(
        call(project, "validate vaujany_forest vaujany_open steg bad_ischl --quiet --rocks 1000 --out few")
            .code,
        5);
    const auto of_case = [&](const std::string& name) {
        std::map<std::pair<std::string, std::string>, double> values;
        const config::Table figures = result_table(project, "few/figures.csv");
        for (std::size_t row = 0; row < figures.rows(); ++row) {
            if (figures.text(row, "case") == name && !figures.text(row, "value").empty()) {
                values[{figures.text(row, "variant"), figures.text(row, "quantity")}] =
                    std::stod(figures.text(row, "value"));
            }
        }
        return values;
    };
    const double speed_error_mps = 4.0 * 3.0 / std::sqrt(1000.0);
    const double hits_error = 4.0 * 2.2 / std::sqrt(1000.0);
    const double share_error = 4.0 * std::sqrt(0.33 * 0.67 / 1000.0);
    const auto forest = of_case("vaujany_forest");
    const auto open = of_case("vaujany_open");
    const auto steg = of_case("steg");
    const auto ischl = of_case("bad_ischl");
    for (const std::string variant : {"strict", "default"}) {
        if (variant == "strict") {
            EXPECT_NEAR(forest.at({variant, "tree_hits_mean"}), 0.5 * (2.52 + 3.28), 0.38 + hits_error);
            EXPECT_NEAR(steg.at({variant, "run_out_mean_m"}), 453.0, 18.0);
        } else {
            // Misses (at least 2.52 hits and 435 m): what validation/VERDICTS.md prints, within four standard
            // errors of 1000 rocks (31 m between rocks at Steg).
            EXPECT_NEAR(forest.at({variant, "tree_hits_mean"}), 2.32, hits_error);
            EXPECT_NEAR(steg.at({variant, "run_out_mean_m"}), 426.0, 4.0 * 31.0 / std::sqrt(1000.0));
        }
        EXPECT_NEAR(forest.at({variant, "max_speed_mean_mps"}), 0.5 * (11.7 + 13.48), 0.89 + speed_error_mps)
            << variant;
        EXPECT_GE(ischl.at({variant, "reaching_share:net"}), 0.999) << variant;
        EXPECT_NEAR(ischl.at({variant, "energy_mean_kj:net"}), 349.0, 66.0 + 4.0 * 90.0 / std::sqrt(1000.0))
            << variant;
    }
    // The default misses it: with facets every second rock stops above B (validation/README.md).
    EXPECT_NEAR(open.at({"strict", "stopped_share:B"}), 0.33, 0.05 + share_error);
    EXPECT_GT(ischl.at({"strict_scatter", "energy_deviation_kj:net"}),
              1.5 * ischl.at({"strict", "energy_deviation_kj:net"}));
}

TEST(Validate, MovesSomethingWithEveryChoice) {
    const SampleProject project;
    ASSERT_EQ(
        call(project, "validate vaujany_forest vaujany_open steg bad_ischl --quiet --rocks 50 --out few")
            .code,
        5);
    const config::Table choices = result_table(project, "few/choices.csv");
    std::map<std::string, std::string> rebuilt;
    std::map<std::string, bool> moved;
    for (std::size_t row = 0; row < choices.rows(); ++row) {
        const std::string figure_of_case = choices.text(row, "case") + ' ' + choices.text(row, "quantity");
        const std::string value = choices.text(row, "strict") + ' ' + choices.text(row, "default");
        if (choices.text(row, "choice") == "as rebuilt") {
            rebuilt[figure_of_case] = value;
        } else {
            moved[choices.text(row, "case") + ": " + choices.text(row, "choice")] |=
                rebuilt.at(figure_of_case) != value;
        }
    }
    EXPECT_GT(moved.size(), 40U);
    for (const auto& [choice, has_moved] : moved) {
        EXPECT_TRUE(has_moved) << choice;
    }
}

TEST(Validate, JudgesTheForestWithOneSetOfSettings) {
    const SampleProject project;
    const Outcome light = call(project, "validate forest_light --quiet --threads 1 --rocks 20 --out light");
    EXPECT_EQ(light.code, 5) << light.err;
    EXPECT_NE(light.out.find("missed: trees' light, r, 35 deg south 0.803"), std::string::npos) << light.out;
    EXPECT_NE(light.out.find("note: --rocks changes nothing here"), std::string::npos) << light.out;
    EXPECT_EQ(light.out.find("strict"), std::string::npos) << light.out;
    const config::Table verdicts = result_table(project, "light/verdicts.csv");
    EXPECT_GT(verdicts.rows(), 24U);
    for (std::size_t row = 0; row < verdicts.rows(); ++row) {
        EXPECT_EQ(verdicts.text(row, "strict"), "");
        EXPECT_NE(verdicts.text(row, "default"), "");
    }
    EXPECT_GT(result_table(project, "light/plots.csv").rows(), 6U * 333U);
    const Outcome again = shell(project,
                                "\"$bannwald\" validate forest_light --quiet --threads 3 --rocks 20 "
                                "--out again; diff -r light again\n");
    EXPECT_EQ(again.code, 0) << again.out << again.err;
    EXPECT_EQ(call(project, "validate forest_production --quiet --out production").code, 0);
}

TEST(Validate, LeavesNothingOfAForestCaseWhenInterrupted) {
    const SampleProject project;
    const Outcome outcome =
        shell(project, interrupted_once("mine", "validate forest_yield --quiet --out mine", "TERM"));
    EXPECT_EQ(outcome.code, 75) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(project.file("mine")));
}

TEST(Validate, ListsItsCases) {
    const SampleProject project;
    const Outcome outcome = call(project, "validate --list " + even_cases);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_NE(outcome.out.find("even_plane"), std::string::npos);
    EXPECT_NE(outcome.out.find("even slope of 38 degrees with a stand"), std::string::npos);
}

TEST(Validate, TakesASurveyedProfile) {
    const SampleProject project;
    project.write("surveyed.csv", "distance_m,height_m,surface\n0,500,fine_debris\n600,0,\n");
    const Outcome outcome =
        call(project, "validate even_plane " + even_cases + "--quiet --out out --profile surveyed.csv");
    EXPECT_EQ(outcome.code, 5) << outcome.err;
    EXPECT_NE(outcome.out.find("note: profile.csv replaced by surveyed.csv"), std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find("The profile is surveyed.csv, the user's own"), std::string::npos)
        << outcome.out;
    EXPECT_EQ(outcome.out.find("likely cause"), std::string::npos) << outcome.out;
    EXPECT_EQ(call(project, "validate all " + even_cases + "--profile surveyed.csv").code, 2);
}

TEST(Validate, LeavesNothingWhenInterrupted) {
    const SampleProject project;
    const Outcome outcome = shell(
        project,
        interrupted_once("mine", "validate even_plane " + even_cases + "--quiet --rocks 5000000 --out mine",
                         "TERM"));
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
}  // namespace coupling::validate_test
