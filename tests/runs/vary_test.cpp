// A scenario under other settings, through the program.

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>

#include "config/table/table.hpp"
#include "tests/runs/years.hpp"

namespace coupling::vary_runs_test {
namespace {

const std::string study = "vary scenario.ini factors.csv --quiet --set release.rocks=400 ";

config::Table rows_of(const SampleProject& project, const std::string& folder) {
    std::istringstream in{project.read(folder + "/vary.csv")};
    return config::Table::read(in, "vary.csv");
}

TEST(Vary, RunsTheScenarioAndEachCombination) {
    const SampleProject project;
    project.write("factors.csv",
                  "setting,values,how\nground.3.r_t,0.6 0.85,alone\nrelease.diameter_m,0.5 1,crossed\n"
                  "rockfall.motion,picus pir3d,crossed\n");
    ASSERT_EQ(call(project, study + "--threads 1 --out one").code, 0);
    const config::Table rows = rows_of(project, "one");
    ASSERT_EQ(rows.rows(), (1U + 2U + 4U) * 2U) << "two targets";
    EXPECT_EQ(rows.text(0, "moved"), "none");
    EXPECT_EQ(rows.text(2, "ground.3.r_t"), "0.6");
    EXPECT_EQ(rows.text(2, "moved"), "alone");
    EXPECT_EQ(rows.text(12, "rockfall.motion"), "pir3d");
    // The scenario's own values, crossed, are the scenario.
    for (const char* column : {"share_bare", "energy_mean_bare_kj", "protection_percent", "run_out_mean_m"}) {
        EXPECT_EQ(rows.text(0, column), rows.text(6, column)) << column;
    }
    EXPECT_NE(rows.text(2, "run_out_mean_m"), rows.text(4, "run_out_mean_m"));
    const std::string page = project.read("one/report.html");
    EXPECT_NE(page.find("class=\"tornado\""), std::string::npos);
    EXPECT_NE(page.find(">ground.3.r_t</text>"), std::string::npos);

    ASSERT_EQ(call(project, study + "--threads 3 --out three").code, 0);
    EXPECT_EQ(project.read("one/vary.csv"), project.read("three/vary.csv"));
    EXPECT_EQ(page, project.read("three/report.html"));
}

TEST(Vary, GivesTheFiguresOfTheRunItself) {
    const SampleProject project;
    project.write("factors.csv", "setting,values,how\nrelease.diameter_m,0.8,alone\n");
    ASSERT_EQ(call(project, study + "--out study").code, 0);
    ASSERT_EQ(call(project,
                   "run scenario.ini --quiet --set release.rocks=400 --set release.diameter_m=0.8 "
                   "--out run")
                  .code,
              0);
    const config::Table rows = rows_of(project, "study");
    std::istringstream in{project.read("run/tables/protection.csv")};
    const config::Table run = config::Table::read(in, "protection.csv");
    EXPECT_NEAR(std::stod(rows.text(2, "protection_percent")), std::stod(run.text(0, "protection_percent")),
                0.01);
}

TEST(Vary, ReplacesAStudyOnlyIfAsked) {
    const SampleProject project;
    project.write("factors.csv", "setting,values,how\nrelease.diameter_m,0.5,alone\n");
    ASSERT_EQ(call(project, study + "--out study").code, 0);
    EXPECT_EQ(call(project, study + "--out study").code, 2) << "a study is there already";
    EXPECT_EQ(call(project, study + "--out study --overwrite").code, 0);
}

TEST(VaryOverYears, PairsRegimesAsTheRunItselfDoes) {
    const ForestProject project;
    project.write("clear.csv", "treatment,first_year\nclear_cut,1\n");
    const std::string members =
        "--quiet --set trees.file= --set stands.records=records.csv --set run.replicates=3 "
        "--set climate.sequence=random --set \"regimes.list=none, clear.csv\" --set release.rocks=300 "
        "--set run.rockfall_every=2 ";
    project.write("factors.csv", "setting,values,how\nrelease.diameter_m,2.5,alone\nrun.seed,9,alone\n");
    ASSERT_EQ(call(project, "vary scenario.ini factors.csv --out study " + members).code, 0);
    const config::Table rows = rows_of(project, "study");
    const std::size_t targets = table(project, "targets.csv").rows();
    ASSERT_EQ(rows.rows(), 3U * 2U * targets) << "the scenario, a diameter, a seed; two regimes";

    // The first rows are the scenario: means over the years 2 and 4 of what the run's own tables have.
    ASSERT_EQ(call(project, "run scenario.ini --out run " + members).code, 0);
    const config::Table years = table(project, "run/tables/regimes_by_year.csv");
    const config::Table pairs = table(project, "run/tables/regime_differences.csv");
    const auto mean_of = [](const config::Table& figures, const std::string& column,
                            const std::string& regime, const std::string& target) {
        double sum = 0.0;
        int count = 0;
        for (std::size_t row = 0; row < figures.rows(); ++row) {
            if (figures.text(row, "quantity") == "protection_percent" &&
                figures.text(row, "regime") == regime && figures.text(row, "target_id") == target &&
                figures.text(row, "year") != "0") {
                sum += number(figures, row, column);
                ++count;
            }
        }
        EXPECT_EQ(count, 2) << regime << ' ' << target;
        return sum / count;
    };
    for (std::size_t row = 0; row < 2 * targets; ++row) {
        const std::string regime = rows.text(row, "regime");
        const std::string target = rows.text(row, "target_id");
        EXPECT_EQ(rows.text(row, "moved"), "none");
        EXPECT_NEAR(number(rows, row, "protection_percent"), mean_of(years, "mean", regime, target), 0.02);
        if (regime == "clear") {
            EXPECT_EQ(rows.text(row, "pairs"), "3");
            EXPECT_NEAR(number(rows, row, "difference_percent"),
                        mean_of(pairs, "mean_difference", regime, target), 0.02);
            EXPECT_LT(number(rows, row, "difference_percent"), 0.0) << "all trees are cut in year 1";
            EXPECT_LT(number(rows, row, "difference_low_95"), number(rows, row, "difference_percent"));
            EXPECT_EQ(rows.text(row, "rank"), "2");
        }
    }
    EXPECT_NE(rows.text(0, "protection_percent"), rows.text(2 * targets, "protection_percent"));
    const std::string page = project.read("study/report.html");
    EXPECT_NE(page.find("class=\"tornado\""), std::string::npos);
    EXPECT_NE(page.find(">release.diameter_m</text>"), std::string::npos);
    EXPECT_NE(page.find(">run.seed</text>"), std::string::npos);

    project.write("factors.csv", "setting,values,how\nrun.rockfall_every,0,alone\n");
    const Outcome without = call(project, "vary scenario.ini factors.csv --out none " + members);
    EXPECT_EQ(without.code, 2);
    EXPECT_NE(without.err.find("run.rockfall_every 0"), std::string::npos) << without.err;
    EXPECT_FALSE(std::filesystem::exists(project.file("none")));
}

}  // namespace
}  // namespace coupling::vary_runs_test
