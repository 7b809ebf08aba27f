// The barrier that the rocks at roads and houses ask for, without any net given.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/runs/years.hpp"

namespace coupling::target_design_test {
namespace {

constexpr const char* run_of_2000 = "run scenario.ini --quiet --set release.rocks=2000 ";
constexpr const char* own_rule =
    "--set design.rule=own --set design.percentile=90 --set design.energy_factor=1.2 "
    "--set design.height_factor=1.1 --set design.freeboard_m=0.5 ";

/// The order statistic that the share of all values does not exceed.
double percentile_of(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    const double rank = std::ceil(share * static_cast<double>(values.size()));
    return values[static_cast<std::size_t>(rank) - 1];
}

/// A column of the arrivals at a target on a slope.
std::vector<double> arrivals_of(const config::Table& arrivals, const std::string& target,
                                const std::string& cover, const std::string& column) {
    std::vector<double> values;
    for (std::size_t row = 0; row < arrivals.rows(); ++row) {
        if (arrivals.text(row, "target_id") == target && arrivals.text(row, "cover") == cover) {
            values.push_back(number(arrivals, row, column));
        }
    }
    return values;
}

TEST(TargetDesign, FollowsFromTheArrivalsAndTheRule) {
    const SampleProject project;
    const Outcome outcome = call(project, std::string{run_of_2000} + own_rule + "--out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table designs = table(project, "out/tables/target_design.csv");
    const config::Table arrivals = table(project, "out/tables/arrivals.csv");
    ASSERT_EQ(designs.rows(), 4U);  // road and house, with forest and without
    for (std::size_t row = 0; row < designs.rows(); ++row) {
        const std::string& target = designs.text(row, "target_id");
        const std::string& cover = designs.text(row, "cover");
        const std::vector<double> energies_kj = arrivals_of(arrivals, target, cover, "energy_kj");
        ASSERT_GT(energies_kj.size(), 20U);
        EXPECT_EQ(number(designs, row, "reached"), static_cast<double>(energies_kj.size()));
        const double energy_kj = percentile_of(energies_kj, 0.9);
        const double height_m = percentile_of(arrivals_of(arrivals, target, cover, "top_height_m"), 0.9);
        // Bins of 128 to a doubling are 0.55 % wide; a neighbouring order statistic may lie between.
        EXPECT_NEAR(number(designs, row, "percentile_energy_kj"), energy_kj, 0.02 * energy_kj);
        EXPECT_NEAR(number(designs, row, "percentile_height_m"), height_m, 0.03 * height_m);
        EXPECT_NEAR(number(designs, row, "design_energy_kj"),
                    1.2 * number(designs, row, "percentile_energy_kj"), 1e-3);
        EXPECT_NEAR(number(designs, row, "design_height_m"),
                    1.1 * number(designs, row, "percentile_height_m") + 0.5, 2e-3);
        EXPECT_GE(number(designs, row, "design_capacity_kj"), number(designs, row, "design_energy_kj"));
        EXPECT_GE(number(designs, row, "sold_height_m"), number(designs, row, "design_height_m"));
        EXPECT_LT(number(designs, row, "sold_height_m") - 0.5 - 1e-9,
                  std::max(1.5, number(designs, row, "design_height_m")));
    }
    EXPECT_NE(project.read("out/report.html").find("Barriers at the targets"), std::string::npos);
}

TEST(TargetDesign, IsLeftEmptyWhereTooFewRocksArrive) {
    const SampleProject project;
    const Outcome outcome = call(project, std::string{"run scenario.ini --quiet --set release.rocks=40 "} +
                                              own_rule + "--set design.percentile=99 --out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table designs = table(project, "out/tables/target_design.csv");
    for (std::size_t row = 0; row < designs.rows(); ++row) {
        EXPECT_LT(number(designs, row, "reached"), 100.0);
        EXPECT_EQ(designs.text(row, "design_energy_kj"), "");
        EXPECT_EQ(designs.text(row, "design_class"), "");
    }
    EXPECT_NE(project.read("out/report.html").find("of at least 100"), std::string::npos);
}

TEST(TargetDesign, IsThereOnlyWithARule) {
    const SampleProject project;
    ASSERT_EQ(call(project, std::string{run_of_2000} + "--out out").code, 0);
    EXPECT_FALSE(std::filesystem::exists(project.file("out/tables/target_design.csv")));
    EXPECT_EQ(project.read("out/report.html").find("Barriers at the targets"), std::string::npos);
}

TEST(TargetDesign, IsWrittenInAllLanguages) {
    const SampleProject project;
    for (const auto& [language, words] : {std::pair{"de", "Schutzbauten bei den Schutzgütern"},
                                          std::pair{"fr", "Filets pare-blocs au droit des enjeux"},
                                          std::pair{"it", "Opere presso gli oggetti"}}) {
        const Outcome outcome = call(project, std::string{run_of_2000} + own_rule + "--out out_" + language +
                                                  " --set report.language=" + language);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_NE(project.read(std::string{"out_"} + language + "/report.html").find(words),
                  std::string::npos);
    }
}

}  // namespace
}  // namespace coupling::target_design_test
