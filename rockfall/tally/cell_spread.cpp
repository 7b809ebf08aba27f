#include "rockfall/tally/cell_spread.hpp"

#include <algorithm>
#include <cmath>

namespace rockfall {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
constexpr double j2_per_hj2 = 1e4;

std::uint32_t all_passages(const CellSpread& cell) {
    std::uint32_t all = 0;
    for (const std::uint32_t of_group : cell.passages) {
        all += of_group;
    }
    return all;
}

/// Of single draws, from the variance of the means of groups of them.
double deviation_of_draws(double variance_of_groups, std::uint32_t strata) {
    const double draws_of_group = static_cast<double>(strata) / static_cast<double>(CellSpread::groups);
    return std::sqrt(draws_of_group * std::max(0.0, variance_of_groups));
}

}  // namespace

void CellSpread::add(std::uint32_t stratum, float energy_j) {
    const std::size_t group = stratum % groups;
    const auto energy = static_cast<double>(energy_j);
    ++passages[group];
    energy_sum_j[group] += static_cast<std::uint64_t>(energy + 0.5);
    energy_squares_hj2 += static_cast<std::uint64_t>(energy * energy / j2_per_hj2 + 0.5);
}

void CellSpread::add(const CellSpread& other) {
    for (std::size_t g = 0; g < groups; ++g) {
        passages[g] += other.passages[g];
        energy_sum_j[g] += other.energy_sum_j[g];
    }
    energy_squares_hj2 += other.energy_squares_hj2;
}

double reach_spread(const CellSpread& cell, std::uint64_t fed_rocks, std::uint32_t strata) {
    const std::uint32_t all = all_passages(cell);
    if (all < least_spread_passages || fed_rocks == 0) {
        return not_known;
    }
    constexpr auto count = static_cast<double>(CellSpread::groups);
    const double fed_of_group = static_cast<double>(fed_rocks) / count;
    const double mean = std::min(1.0, all / count / fed_of_group);
    double squares = 0.0;
    for (const std::uint32_t of_group : cell.passages) {
        const double off = of_group / fed_of_group - mean;
        squares += off * off;
    }
    const double by_chance = mean * (1.0 - mean) / fed_of_group;
    return deviation_of_draws(squares / (count - 1.0) - by_chance, strata);
}

double energy_spread_j(const CellSpread& cell, std::uint32_t strata) {
    const std::uint32_t all = all_passages(cell);
    if (all < least_spread_passages) {
        return not_known;
    }
    double sum_j = 0.0;
    double between = 0.0;  // sum of n times the square of the mean of a group
    double squared_counts = 0.0;
    double filled = 0.0;
    for (std::size_t g = 0; g < CellSpread::groups; ++g) {
        const double rocks = cell.passages[g];
        if (rocks > 0.0) {
            const auto of_group_j = static_cast<double>(cell.energy_sum_j[g]);
            sum_j += of_group_j;
            between += of_group_j * of_group_j / rocks;
            squared_counts += rocks * rocks;
            filled += 1.0;
        }
    }
    const double rocks = all;
    if (filled < 2.0 || rocks <= filled) {
        return not_known;
    }
    const double within =
        std::max(0.0, j2_per_hj2 * static_cast<double>(cell.energy_squares_hj2) - between) / (rocks - filled);
    const double of_groups = (between - sum_j * sum_j / rocks) / (filled - 1.0);
    const double even_count = (rocks - squared_counts / rocks) / (filled - 1.0);
    return deviation_of_draws((of_groups - within) / even_count, strata);
}

}  // namespace rockfall
