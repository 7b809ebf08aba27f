#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>
#include <string>

#include "tests/runs/program.hpp"
#include "tests/runs/years.hpp"

namespace coupling::parameter_draws_runs_test {
namespace {

const std::string run = "run scenario.ini --set release.rocks_per_source=2000 ";

TEST(ParameterDraws, GiveTwoIntervalsAndNameTheirCause) {
    const SampleProject project;
    const Outcome outcome = call(project, run + "--out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("with what is not known of ground and trees"), std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find("mostly by "), std::string::npos) << outcome.out;
    const std::string intervals = project.read("out/tables/intervals.csv");
    EXPECT_NE(intervals.find("\nroad,bare,reached,"), std::string::npos) << intervals;
    EXPECT_NE(intervals.find(",run_out_mean,"), std::string::npos) << intervals;
    EXPECT_NE(project.read("out/tables/parameter_draws.csv").find("\n63,losses,"), std::string::npos);
    EXPECT_NE(project.read("out/summary.json").find("interval_95_of_all"), std::string::npos);
    EXPECT_NE(project.read("out/report.html").find("How sure the figures are"), std::string::npos);
}

TEST(ParameterDraws, BlameNoTreesForTheBareSlope) {
    const SampleProject project;
    ASSERT_EQ(call(project, run + "--out out").code, 0);
    std::istringstream rows{project.read("out/tables/intervals.csv")};
    int of_bare = 0;
    for (std::string row; std::getline(rows, row);) {
        if (row.find(",bare,") != std::string::npos) {
            ++of_bare;
            EXPECT_EQ(row.find("tree_energy"), std::string::npos) << row;
        }
    }
    EXPECT_GT(of_bare, 2);
}

TEST(ParameterDraws, AreTheSameBytesOnAnyNumberOfThreads) {
    const SampleProject project;
    ASSERT_EQ(call(project, run + "--threads 1 --out first").code, 0);
    const Outcome outcome =
        shell(project, "\"$bannwald\" " + run + "--threads 5 --out second && diff -r first second\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

/// Chance hides a spread from few rocks: then there is no second interval, rather than a narrow one.
TEST(ParameterDraws, GiveProtectionASecondIntervalOnlyOfRocksEnough) {
    const SampleProject project;
    std::size_t with = 0;
    for (const std::string rocks : {"5", "30", "120", "2000"}) {
        ASSERT_EQ(call(project,
                       "run scenario.ini --quiet --overwrite --out out --set "
                       "release.rocks_per_source=" +
                           rocks)
                      .code,
                  0);
        const config::Table intervals = table(project, "out/tables/intervals.csv");
        const config::Table protection = table(project, "out/tables/protection.csv");
        const config::Table draws = table(project, "out/tables/parameter_draws.csv");
        std::set<std::string> strata;
        for (std::size_t row = 0; row < draws.rows(); ++row) {
            strata.insert(draws.text(row, "stratum"));
        }
        for (std::size_t row = 0; row < intervals.rows(); ++row) {
            if (intervals.text(row, "quantity") != "protection") {
                continue;
            }
            const bool has_both = !intervals.text(row, "all_low").empty();
            with += has_both ? 1 : 0;
            // Three arrivals to a stratum, at the least.
            EXPECT_TRUE(!has_both ||
                        number(protection, 0, "reached_bare") >= 3.0 * static_cast<double>(strata.size()))
                << rocks;
        }
    }
    EXPECT_GT(with, 0U);
}

TEST(ParameterDraws, LetRocksFallByTheTablesWhereNothingIsDrawn) {
    const SampleProject project;
    ASSERT_EQ(call(project, run + "--set run.parameter_draws=no --out off").code, 0);
    project.write("parameters.csv",
                  "parameter,width\nlosses,0\nlosses_on,0\nlosses_on.pasture,0\nlosses_on.solid_rock,0\n"
                  "friction,0\nstopping,0\njump_angle,0\nsideways,0\ntree_energy,0\n");
    ASSERT_EQ(call(project, run + "--set run.parameters=parameters.csv --out known").code, 0);
    const Outcome outcome =
        shell(project, "diff -r off/tables known/tables && diff -r off/rasters known/rasters\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_EQ(project.read("off/tables/intervals.csv"), "");
    ASSERT_EQ(call(project, run + "--out drawn").code, 0);
    EXPECT_NE(project.read("drawn/tables/rocks.csv"), project.read("off/tables/rocks.csv"));
}

TEST(ParameterDraws, OfReplicatesAreTheSameInAllRegimesAndChangeNothingInTheFirst) {
    const ForestProject project;
    const std::string members = std::string{four_members} + "--set run.years=2 ";
    const Outcome outcome = call(project, members + "--out drawn");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    ASSERT_EQ(call(project, members + "--set run.parameter_draws=no --out known").code, 0);
    const config::Table drawn = table(project, "drawn/tables/runs.csv");
    const config::Table known = table(project, "known/tables/runs.csv");
    ASSERT_EQ(drawn.rows(), known.rows());
    std::map<std::string, std::string> bare;
    for (std::size_t row = 0; row < drawn.rows(); ++row) {
        const std::string replicate = drawn.text(row, "replicate");
        EXPECT_EQ(drawn.text(row, "run_out_mean_m") == known.text(row, "run_out_mean_m"), replicate == "1")
            << row;
        if (drawn.text(row, "cover") == "bare") {
            const std::string at = replicate + " " + drawn.text(row, "year");
            const std::string& first = bare.try_emplace(at, drawn.text(row, "run_out_mean_m")).first->second;
            EXPECT_EQ(drawn.text(row, "run_out_mean_m"), first) << at;
        }
    }
    EXPECT_EQ(table(project, "drawn/tables/replicate_draws.csv").text(0, "replicate"), "2");
    EXPECT_EQ(project.read("known/tables/replicate_draws.csv"), "");
    EXPECT_NE(project.read("drawn/report.html").find("Each replicate but the first has its own draw"),
              std::string::npos);
}

}  // namespace
}  // namespace coupling::parameter_draws_runs_test
