#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "tests/runs/years.hpp"

namespace coupling::paths_test {
namespace {

TEST(Paths, OfRocksThatTheUserNamesAreKept) {
    const SampleProject project;
    const Outcome outcome = call(project,
                                 "run scenario.ini --quiet --set output.sample_paths=0 --set "
                                 "\"output.path_rocks=11, 3\" --out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table corners = table(project, "out/tables/trajectories.csv");
    std::set<std::string> kept;
    for (std::size_t row = 0; row < corners.rows(); ++row) {
        kept.insert(corners.text(row, "rock") + " " + corners.text(row, "cover"));
    }
    EXPECT_EQ(kept, (std::set<std::string>{"11 bare", "11 forest", "3 bare", "3 forest"}));
    EXPECT_NE(project.read("out/report.html").find("rock 11: output.path_rocks"), std::string::npos);
}

/// What a block has lost never comes back, and nothing is taken from it before it moves.
TEST(Paths, OfBlocksHaveEnergiesOverTime) {
    const SampleProject project;
    const Outcome outcome = call(project,
                                 "run scenario.ini --quiet --set output.sample_paths=20 --set "
                                 "\"output.path_rocks=3\" --set rockfall.motion=rigid --out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table series = table(project, "out/tables/path_series.csv");
    const config::Table rocks = table(project, "out/tables/rocks.csv");
    const auto number = [&](std::size_t row, const char* column) {
        return std::stod(series.text(row, column));
    };
    const auto path = [&](std::size_t row) { return series.text(row, "rock") + series.text(row, "cover"); };
    std::map<std::string, double> end_s;
    std::map<std::string, double> largest_kj;
    for (std::size_t row = 0; row < rocks.rows(); ++row) {
        end_s[rocks.text(row, "rock") + rocks.text(row, "cover")] = std::stod(rocks.text(row, "time_s"));
        largest_kj[rocks.text(row, "rock") + rocks.text(row, "cover")] =
            std::stod(rocks.text(row, "max_energy_kj"));
    }
    std::string reasons;
    std::size_t ends = 0;
    for (std::size_t row = 0; row < series.rows(); ++row) {
        const double rounding_kj = 0.01 * largest_kj.at(path(row)) + 0.01;  // between corners straight on
        if (number(row, "time_s") == 0.0) {
            reasons += series.text(row, "chosen") + " ";
            EXPECT_NEAR(number(row, "taken_kj"), 0.0, 1e-3);
            EXPECT_EQ(number(row, "displacement_m"), 0.0);
        }
        EXPECT_LE(number(row, "energy_kj"), largest_kj.at(path(row)) + rounding_kj);
        if (row + 1 == series.rows() || path(row + 1) != path(row)) {
            EXPECT_NEAR(number(row, "time_s"), end_s.at(path(row)), 0.01);
            ++ends;
        } else {
            EXPECT_GT(number(row + 1, "time_s"), number(row, "time_s"));
            EXPECT_GE(number(row + 1, "taken_kj"), number(row, "taken_kj") - rounding_kj);
        }
    }
    EXPECT_GE(ends, 2U);
    for (const char* reason : {"fastest", "farthest", "median", "named"}) {
        EXPECT_NE(reasons.find(reason), std::string::npos) << reason;
    }
    const config::Table means = table(project, "out/tables/path_means.csv");
    EXPECT_GE(std::stod(means.text(0, "rocks")), 20.0);
    EXPECT_NEAR(std::stod(means.text(0, "displacement_m")), 0.0, 1e-9);
    EXPECT_NE(project.read("out/report.html").find("Acceleration over time"), std::string::npos);
}

class PathsOfModel : public ::testing::TestWithParam<const char*> {};

/// Time rises along each path, ends with the fall, and carries the rock no further than its speed.
TEST_P(PathsOfModel, HaveTimesAndSpeedsThatFitTheirPlaces) {
    const SampleProject project;
    const std::string model = GetParam();
    const Outcome outcome =
        call(project, "run scenario.ini --quiet --set output.sample_paths=20 --set rockfall.motion=" + model +
                          " --set run.parameter_draws=no --out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table corners = table(project, "out/tables/trajectories.csv");
    const config::Table rocks = table(project, "out/tables/rocks.csv");
    std::map<std::string, double> end_s;
    for (std::size_t row = 0; row < rocks.rows(); ++row) {
        end_s[rocks.text(row, "rock") + rocks.text(row, "cover")] = std::stod(rocks.text(row, "time_s"));
    }
    const auto number = [&](std::size_t row, const char* column) {
        return std::stod(corners.text(row, column));
    };
    const auto path = [&](std::size_t row) { return corners.text(row, "rock") + corners.text(row, "cover"); };
    std::size_t pieces = 0;
    for (std::size_t row = 0; row < corners.rows(); ++row) {
        const bool is_last = row + 1 == corners.rows() || path(row + 1) != path(row);
        if (is_last) {
            EXPECT_NEAR(number(row, "time_s"), end_s.at(path(row)), 0.01) << path(row);
            continue;
        }
        const double passed_s = number(row + 1, "time_s") - number(row, "time_s");
        ASSERT_GE(passed_s, 0.0) << path(row);
        const double way_m = std::hypot(number(row + 1, "x_m") - number(row, "x_m"),
                                        number(row + 1, "y_m") - number(row, "y_m"),
                                        number(row + 1, "z_m") - number(row, "z_m"));
        const double fastest_mps = std::max(number(row, "speed_mps"), number(row + 1, "speed_mps"));
        // Places are rounded to centimetres, times to milliseconds. Blocks jolt between their corners.
        const double jolts = model == "rigid" ? 1.5 : 1.0;
        EXPECT_LE(way_m, jolts * fastest_mps * (passed_s + 0.001) + 0.02) << path(row) << " " << passed_s;
        ++pieces;
    }
    EXPECT_GT(pieces, 100U);
}

INSTANTIATE_TEST_SUITE_P(Motion, PathsOfModel, ::testing::Values("picus", "pir3d", "classical", "rigid"));

}  // namespace
}  // namespace coupling::paths_test
