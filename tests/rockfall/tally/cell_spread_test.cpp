#include "rockfall/tally/cell_spread.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

namespace rockfall::cell_spread_test {
namespace {

/// A cell that rocks of strata pass with a probability and an energy of their own.
struct Draws {
    double reach = 0.3;
    double reach_deviation = 0.0;
    double energy_j = 2e5;
    double energy_deviation_j = 0.0;
    double energy_of_rocks_j = 5e4;  ///< deviation among the rocks of a stratum
};

/// Means over many cells, so that the chance of one set of draws goes out.
struct Means {
    double reach = 0.0;
    double energy_j = 0.0;
};

Means squares_over_cells(const Draws& draws, std::uint32_t strata, int rocks_of_stratum) {
    constexpr int cells = 400;
    std::mt19937_64 random{7};
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    Means means;
    for (int i = 0; i < cells; ++i) {
        CellSpread cell;
        for (std::uint32_t stratum = 0; stratum < strata; ++stratum) {
            const double reach = draws.reach + draws.reach_deviation * normal(random);
            const double energy_j = draws.energy_j + draws.energy_deviation_j * normal(random);
            for (int rock = 0; rock < rocks_of_stratum; ++rock) {
                if (uniform(random) < reach) {
                    cell.add(stratum, static_cast<float>(std::max(
                                          0.0, energy_j + draws.energy_of_rocks_j * normal(random))));
                }
            }
        }
        const double reach = reach_spread(cell, std::uint64_t{strata} * rocks_of_stratum, strata);
        const double energy_j = energy_spread_j(cell, strata);
        means.reach += reach * reach / cells;
        means.energy_j += energy_j * energy_j / cells;
    }
    return means;
}

TEST(CellSpread, FindsTheDeviationOfTheDraws) {
    const Draws draws{.reach_deviation = 0.06, .energy_deviation_j = 4e4};
    for (const std::uint32_t strata : {16U, 32U, 64U}) {
        const Means squares = squares_over_cells(draws, strata, 200);
        // A variance of 15 degrees of freedom scatters by the root of 2 / 15: four errors of the mean of 400.
        const double tolerance = 4.0 * std::sqrt(2.0 / 15.0 / 400.0);
        EXPECT_NEAR(squares.reach / (0.06 * 0.06), 1.0, 1.6 * tolerance) << strata;
        EXPECT_NEAR(squares.energy_j / 16e8, 1.0, 1.6 * tolerance) << strata;
    }
}

TEST(CellSpread, LeavesTheChanceOfRocksOut) {
    // Half of all cells show nothing, the others a part of what chance alone does.
    const Draws draws{};
    const Means squares = squares_over_cells(draws, 64, 50);
    const double by_chance = 0.3 * 0.7 / 50.0;
    EXPECT_LT(squares.reach, 0.3 * by_chance);
    EXPECT_LT(squares.energy_j, 0.3 * 25e8 / 15.0);
}

TEST(CellSpread, IsNotKnownOfFewRocks) {
    CellSpread cell;
    for (std::uint32_t rock = 0; rock + 1 < least_spread_passages; ++rock) {
        cell.add(rock, 1e5F);
    }
    EXPECT_TRUE(std::isnan(reach_spread(cell, 1000, 64)));
    EXPECT_TRUE(std::isnan(energy_spread_j(cell, 64)));
    cell.add(0, 1e5F);
    EXPECT_FALSE(std::isnan(reach_spread(cell, 1000, 64)));
    EXPECT_EQ(energy_spread_j(cell, 64), 0.0);
    EXPECT_TRUE(std::isnan(reach_spread({}, 0, 64)));
}

RC_GTEST_PROP(CellSpread, AddsUpInAnyOrder, ()) {
    const auto rocks = *rc::gen::container<std::vector<std::pair<std::uint32_t, std::uint32_t>>>(
        rc::gen::pair(rc::gen::inRange(0U, 64U), rc::gen::inRange(0U, 100'000'000U)));
    CellSpread all;
    CellSpread even;
    CellSpread odd;
    for (std::size_t i = 0; i < rocks.size(); ++i) {
        const auto energy_j = static_cast<float>(rocks[i].second);
        all.add(rocks[i].first, energy_j);
        (i % 2 == 0 ? even : odd).add(rocks[i].first, energy_j);
    }
    odd.add(even);
    RC_ASSERT(odd.passages == all.passages);
    RC_ASSERT(odd.energy_sum_j == all.energy_sum_j);
    RC_ASSERT(odd.energy_squares_hj2 == all.energy_squares_hj2);
}

}  // namespace
}  // namespace rockfall::cell_spread_test
