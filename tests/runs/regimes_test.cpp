// What regimes of users do in whole runs, and what tables and pages say of their timber and money.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "tests/runs/years.hpp"

namespace coupling::regimes_test {
namespace {

/// Two regimes of the user's own in two replicates, forest only.
constexpr const char* own_regimes =
    "run scenario.ini --quiet --set trees.file= --set stands.records=records.csv --set run.replicates=2 "
    "--set run.rockfall_every=0 --set climate.sequence=random ";

TEST(OwnRegimes, CountSalvagedTimberInEachTable) {
    const ForestProject project;
    project.write("salvage.csv",
                  "treatment,first_year,every_years,share,oldest_years,left_share\n"
                  "salvage,1,1,0.9,2,\nthin_below,2,,0.2,,0.5\n");
    const Outcome outcome = call(project, std::string{own_regimes} + "--set regimes.list=none,salvage.csv");
    ASSERT_EQ(outcome.code, 0) << outcome.err;

    const config::Table work = table(project, "out/tables/interventions.csv");
    std::map<std::string, double> taken_m3;
    for (std::size_t row = 0; row < work.rows(); ++row) {
        taken_m3[work.text(row, "treatment")] += number(work, row, "taken_m3");
    }
    ASSERT_GT(taken_m3["salvage"], 0.0) << "trees die in four years";

    const config::Table years = table(project, "out/tables/work_by_year.csv");
    EXPECT_EQ(years.rows(), 2U * 2U * 5U) << "regimes, replicates, years: also those without work";
    double salvaged_m3pha = 0.0;
    double removed_m3pha = 0.0;
    for (std::size_t row = 0; row < years.rows(); ++row) {
        const double in = number(years, row, "felled_m3pha") + number(years, row, "salvaged_m3pha");
        const double out = number(years, row, "removed_m3pha") + number(years, row, "left_m3pha");
        EXPECT_NEAR(in, out, 2.1e-4) << "four figures of four decimals, row " << row;
        if (years.text(row, "regime") == "none") {
            EXPECT_EQ(in, 0.0);
        }
        salvaged_m3pha += number(years, row, "salvaged_m3pha");
        removed_m3pha += number(years, row, "removed_m3pha");
    }
    constexpr double area_ha = 0.8;
    EXPECT_NEAR(salvaged_m3pha, taken_m3["salvage"] / area_ha, 0.001 * static_cast<double>(years.rows()));
    EXPECT_NEAR(removed_m3pha, (taken_m3["salvage"] + taken_m3["thin_below"]) / area_ha,
                0.001 * static_cast<double>(years.rows()));

    // The mean of a regime over its replicates, and its paired difference.
    const config::Table means = table(project, "out/tables/regimes_by_year.csv");
    double sum_of_means = 0.0;
    for (std::size_t row = 0; row < means.rows(); ++row) {
        if (means.text(row, "quantity") == "salvaged_m3pha") {
            sum_of_means += number(means, row, "mean");
        }
    }
    EXPECT_NEAR(sum_of_means, salvaged_m3pha / 2.0, 0.0005 * 10.0);
    const std::string differences = project.read("out/tables/regime_differences.csv");
    for (const char* quantity :
         {"felled_m3pha", "salvaged_m3pha", "removed_m3pha", "left_m3pha", "contribution_margin_eur_pha"}) {
        EXPECT_NE(differences.find(quantity), std::string::npos) << quantity;
    }
    const std::string page = project.read("out/report.html");
    for (const char* words : {"Salvaged, m³/ha a year", "Removed from the forest, m³/ha a year",
                              "Contribution margin, EUR/ha a year"}) {
        EXPECT_NE(page.find(words), std::string::npos) << words;
    }
}

TEST(OwnRegimes, RefuseWhatCouldNeverActAndWarnOfWhatNeverDid) {
    const ForestProject project;
    // The run lasts from 2000 (the start) to 2004.
    project.write("late.csv", "treatment,first_year,share\nthin_below,2030,0.2\n");
    const Outcome late = call(project, std::string{own_regimes} + "--set regimes.list=late.csv");
    EXPECT_EQ(late.code, 4);
    EXPECT_NE(late.err.find("late.csv:2"), std::string::npos) << late.err;
    EXPECT_NE(late.err.find("first_year = 2030: thin_below could never act"), std::string::npos) << late.err;
    EXPECT_NE(late.err.find("from 2000 to 2004"), std::string::npos) << late.err;

    project.write("calendar.csv", "treatment,first_year,share\nthin_below,2003,0.2\n");
    project.write("of_run.csv", "treatment,first_year,share\nthin_below,3,0.2\n");
    project.write("never.csv", "name,treatment,from_age_years,share\nold,thin_below,400,0.2\n");
    const Outcome outcome =
        call(project, std::string{own_regimes} + "--set regimes.list=calendar.csv,of_run.csv,never.csv");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("regime never: old never came due"), std::string::npos) << outcome.err;
    const config::Table work = table(project, "out/tables/interventions.csv");
    std::map<std::string, double> felled_m3;
    for (std::size_t row = 0; row < work.rows(); ++row) {
        EXPECT_EQ(work.text(row, "year"), "3");
        felled_m3[work.text(row, "regime")] += number(work, row, "taken_m3");
    }
    EXPECT_GT(felled_m3["of_run"], 0.0);
    EXPECT_EQ(felled_m3["calendar"], felled_m3["of_run"]) << "2003 is year 3";
}

TEST(OwnRegimes, CountSalvagedTimberInComparisons) {
    const ForestProject project;
    project.write("salvage.csv", "treatment,first_year,every_years,share\nsalvage,1,1,0.9\n");
    for (const std::string folder : {"a", "b"}) {
        const Outcome outcome =
            call(project, std::string{own_regimes} + "--set regimes.list=salvage.csv --out " + folder +
                              " --seed " + (folder == "a" ? "1" : "2"));
        ASSERT_EQ(outcome.code, 0) << outcome.err;
    }
    ASSERT_EQ(call(project, "compare a b --quiet --out c.csv").code, 0);
    const config::Table compared = table(project, "c.csv");
    std::map<std::string, double> a;
    for (std::size_t row = 0; row < compared.rows(); ++row) {
        if (compared.text(row, "run") == "A" && compared.text(row, "when") == "mean over years") {
            a[compared.text(row, "quantity")] = number(compared, row, "value");
        }
    }
    EXPECT_GT(a["salvaged_m3pha"], 0.0);
    EXPECT_EQ(a["felled_m3pha"], 0.0);
    EXPECT_NEAR(a["removed_m3pha"], a["salvaged_m3pha"], 0.002);
    EXPECT_NE(a["contribution_margin_eur_pha"], 0.0);
}

}  // namespace
}  // namespace coupling::regimes_test
