#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace coupling::calibrate {

/// Values or places, observed or simulated.
struct Sample {
    bool is_plane = false;                  ///< places; else values, in x
    std::vector<Eigen::Vector2d> points{};  ///< of values y is 0

    [[nodiscard]] std::size_t size() const { return points.size(); }
    [[nodiscard]] bool empty() const { return points.empty(); }
};

/// Of values, in their order.
Sample sample_of_values(const std::vector<double>& values);

/// Every k-th point, so that at most `most` stay: distances between all pairs cost their square.
Sample thinned(const Sample& sample, std::size_t most);

/// E|X - Y| over all pairs. Requires points in both.
double mean_distance(const Sample& a, const Sample& b);

/// 2 E|X - Y| - E|X - X'| - E|Y - Y'|, in the unit of the points; 0 for equal samples (Szekely & Rizzo 2013).
/// Infinite where one is empty. Requires that both are of places, or both of values.
double energy_distance(const Sample& a, const Sample& b);

}  // namespace coupling::calibrate
