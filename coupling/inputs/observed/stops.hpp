#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "coupling/inputs/observed/observed_stop.hpp"

namespace coupling::observed {

/// Where a simulated rock ended.
struct SimulatedStop {
    Eigen::Vector2d start_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d end_m = Eigen::Vector2d::Zero();
    std::uint32_t zone = 0;
    bool left_terrain = false;
};

/// Shares at which quantiles of run-outs are given.
inline constexpr std::array<double, 5> quantile_shares{0.10, 0.25, 0.50, 0.75, 0.90};

/// Run-out, plan distance from release to stop, and how far beside the axis rocks stop.
struct StopFigures {
    std::size_t rocks = 0;
    double mean_m = 0.0;
    double deviation_m = 0.0;  ///< n - 1; NaN of one rock
    std::array<double, quantile_shares.size()> quantiles_m{};
    double longest_m = 0.0;
    double sideways_m = 0.0;    ///< standard deviation of the distances from the axis
    double left_terrain = 0.0;  ///< share that left the terrain: their run-out ends there
};

/// Observed beside simulated stops of a group.
struct StopComparison {
    std::string group;  ///< "" of all
    StopFigures observed;
    StopFigures simulated;
    double largest_distance = 0.0;            ///< between the distributions of run-out (Kolmogorov-Smirnov)
    double distance_by_chance = 0.0;          ///< that 5 % of equal distributions exceed
    double energy_distance_m = 0.0;           ///< between the distributions of run-out
    std::vector<double> observed_run_out_m;   ///< sorted
    std::vector<double> simulated_run_out_m;  ///< sorted
};

/// All stops together, then group by group in the order of their names; no groups where all bear one name.
///
/// A group is held against the rocks of the release zones that its stops came from; stops without zone
/// against all rocks. Where the place of release is unknown, the mean release of those rocks stands for it.
/// The axis of a group leads from the mean release to the mean observed stop. Each rock counts the same.
/// Groups to which no simulated rock belongs are left out. Empty without stops or rocks.
std::vector<StopComparison> compare_stops(std::span<const ObservedStop> observed,
                                          std::span<const SimulatedStop> simulated);

}  // namespace coupling::observed
