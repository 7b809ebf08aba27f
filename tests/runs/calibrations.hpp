#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "config/table/table.hpp"
#include "tests/runs/program.hpp"

namespace coupling {

/// A search that takes a second.
inline const std::string few_sets =
    "--set calibrate.sets=60 --set calibrate.first_sets=64 --set calibrate.most_sets=600 "
    "--set calibrate.rocks=60 ";

/// A search of some seconds whose sets weigh about the same, so that means of theirs are known well.
inline const std::string many_sets =
    "--set calibrate.sets=300 --set calibrate.first_sets=128 --set calibrate.most_sets=3000 "
    "--set calibrate.emulator=yes ";

inline config::Table written_table(const SampleProject& project, const std::string& name) {
    std::istringstream in{project.read(name)};
    return config::Table::read(in, name);
}

/// Rocks of a scenario fall with known factors, into a folder `truth` beside it.
inline void simulate_truth(const SampleProject& project, const std::string& folder,
                           const std::string& factors, const std::string& settings = "") {
    project.write(folder + "truth.csv", factors);
    const Outcome run = call(project, "run " + folder + "scenario.ini --out " + folder +
                                          "truth --overwrite --quiet --seed 9 --set run.parameters=truth.csv "
                                          "--set run.parameter_draws=no --set release.rocks_per_source=30 " +
                                          settings);
    EXPECT_EQ(run.code, 0) << run.err;
}

/// Stops of the truth, every one on the terrain.
inline void write_stops(const SampleProject& project, const std::string& folder) {
    const config::Table rocks = written_table(project, folder + "truth/tables/rocks.csv");
    std::string stops = "x_m,y_m\n";
    for (std::size_t row = 0; row < rocks.rows(); ++row) {
        if (rocks.text(row, "cover") == "forest" && rocks.text(row, "stop_reason") != "left_terrain") {
            stops += rocks.text(row, "x_end_m") + "," + rocks.text(row, "y_end_m") + "\n";
        }
    }
    project.write(folder + "stops.csv", stops);
}

/// Impacts of stored paths of the truth; where a rock rolls, another track begins.
inline void write_tracks(const SampleProject& project) {
    const config::Table impacts = written_table(project, "truth/tables/impacts.csv");
    std::string tracks = "x_m,y_m,track,group\n";
    int part = 0;
    for (std::size_t row = 0; row < impacts.rows(); ++row) {
        if (impacts.text(row, "cover") == "forest") {
            const std::string& rock = impacts.text(row, "rock");
            tracks += impacts.text(row, "x_m") + "," + impacts.text(row, "y_m") + "," + rock + "." +
                      std::to_string(part) + "," + rock + "\n";
            part += impacts.text(row, "onward") == "jumps" ? 0 : 1;
        }
    }
    project.write("impacts.csv", tracks);
}

/// An outline of all places nearer to the sources than 97.5 % of the stops of the truth: half of the 5 %
/// outside lie beyond.
inline void write_outline(const SampleProject& project) {
    const config::Table rocks = written_table(project, "truth/tables/rocks.csv");
    const auto nearest_source = [](const Eigen::Vector2d& at) -> Eigen::Vector2d {
        return {1030.0, std::clamp(at.y(), 2035.0, 2070.0)};
    };
    std::vector<double> distances;
    for (std::size_t row = 0; row < rocks.rows(); ++row) {
        if (rocks.text(row, "cover") == "forest" && rocks.text(row, "stop_reason") != "left_terrain") {
            const Eigen::Vector2d end{std::stod(rocks.text(row, "x_end_m")),
                                      std::stod(rocks.text(row, "y_end_m"))};
            distances.push_back((end - nearest_source(end)).norm());
        }
    }
    ASSERT_GT(distances.size(), 40U);
    std::sort(distances.begin(), distances.end());
    const double reach_m = distances[distances.size() - 1 - distances.size() / 40];
    std::string corners;
    for (int degrees = -90; degrees <= 90; degrees += 10) {
        const double angle = degrees * std::acos(-1.0) / 180.0;
        const double x_m = std::min(1114.0, 1030.0 + reach_m * std::cos(angle));
        const double y_m = (degrees < 0 ? 2035.0 : 2070.0) + reach_m * std::sin(angle);
        corners += std::to_string(x_m) + " " + std::to_string(std::clamp(y_m, 2006.0, 2094.0)) + ", ";
    }
    corners += corners.substr(0, corners.find(','));
    project.write("outline.csv", "wkt\n\"POLYGON ((" + corners + "))\"\n");
}

/// All stems of trees.csv with the wounds that the truth gave them.
inline void write_searched_stems(const SampleProject& project) {
    const config::Table hits = written_table(project, "truth/tables/tree_hits.csv");
    std::map<std::string, int> scars;
    for (std::size_t row = 0; row < hits.rows(); ++row) {
        ++scars[hits.text(row, "tree_id")];
    }
    const config::Table trees = written_table(project, "trees.csv");
    std::string searched = "x_m,y_m,scars,dbh_cm\n";
    for (std::size_t row = 0; row < trees.rows(); ++row) {
        searched += trees.text(row, "x_m") + "," + trees.text(row, "y_m") + "," +
                    std::to_string(scars[trees.text(row, "tree_id")]) + "," + trees.text(row, "dbh_cm") +
                    "\n";
    }
    project.write("searched.csv", searched);
}

/// Weighted mean and deviation of the logarithm of a product of factors.
struct Logarithm {
    double mean = 0.0;
    double deviation = 0.0;
    double error = 0.0;  ///< standard error of the mean, by the weights: that of another seed of the search
};
inline Logarithm logarithm_of(const config::Table& sample, const std::vector<std::string>& parameters) {
    double mean = 0.0;
    double squares = 0.0;
    double squared_weights = 0.0;
    for (std::size_t row = 0; row < sample.rows(); ++row) {
        const double weight = std::stod(sample.text(row, "weight"));
        double product = 0.0;
        for (const std::string& parameter : parameters) {
            product += std::log(std::stod(sample.text(row, parameter)));
        }
        mean += weight * product;
        squares += weight * product * product;
        squared_weights += weight * weight;
    }
    const double deviation = std::sqrt(squares - mean * mean);
    return {mean, deviation, deviation * std::sqrt(squared_weights)};
}

}  // namespace coupling
