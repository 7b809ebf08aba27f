#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coupling::siting {

/// A rock as it first comes to a line, on one slope.
struct LineArrival {
    double along_m = 0.0;  ///< from the first corner
    double energy_kj = 0.0;
};

/// A piece of a line and what comes to it.
struct LineBin {
    double from_m = 0.0;
    double to_m = 0.0;
    std::uint64_t rocks = 0;
    double energy_sum_kj = 0.0;
    std::vector<double> energies_kj;  ///< rising
};

/// Length of a piece of the line [choice: as the tables of targets].
inline constexpr double bin_m = 10.0;

/// The pieces of a line, 10 m each, the last one shorter. Requires a length > 0.
std::vector<LineBin> bins_along(double length_m, std::span<const LineArrival> arrivals);

/// A part of a line where works are needed.
struct Stretch {
    double from_m = 0.0;
    double to_m = 0.0;
    friend bool operator==(const Stretch&, const Stretch&) = default;
};

/// Stretches nearer to each other than this become one: works so close are not built apart [choice].
inline constexpr double joined_gap_m = 20.0;

/// Where works are needed: the pieces with the most energy for each metre, as few as together receive the
/// wanted share of the energy that comes to the line; neighbours become one stretch. Nothing where no energy
/// comes.
std::vector<Stretch> needed_stretches(std::span<const LineBin> bins, double wanted_share);

}  // namespace coupling::siting
