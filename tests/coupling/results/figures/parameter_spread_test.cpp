#include "coupling/results/figures/parameter_spread.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "config/random/distributions.hpp"
#include "config/random/latin_hypercube.hpp"

namespace coupling::parameter_spread_test {
namespace {

constexpr std::size_t strata = 64;
constexpr std::array<std::uint64_t, 3> components{1, 2, 3};

std::vector<std::vector<double>> unit_draws(std::uint64_t seed) {
    auto draws = config::latin_hypercube({.seed = seed}, config::Purpose::test, components, strata);
    for (auto& of_stratum : draws) {
        for (double& u : of_stratum) {
            u = config::normal(u, 0.0, 1.0);
        }
    }
    return draws;
}

/// A figure 10 + 3 z_0 + z_1 of each stratum, known up to the chance of its rocks.
std::vector<StratumFigure> toy(const std::vector<std::vector<double>>& draws, double size, double chance,
                               std::uint64_t seed) {
    std::vector<StratumFigure> figures;
    for (std::size_t k = 0; k < draws.size(); ++k) {
        config::RandomStream stream{{seed, 0, 0, k}, config::Purpose::test};
        const double noise = std::sqrt(chance) * config::normal(stream.uniform(), 0.0, 1.0);
        figures.push_back({10.0 + size * (3.0 * draws[k][0] + draws[k][1]) + noise, chance, k});
    }
    return figures;
}

/// Mean over seeds.
template <class Value>
double mean_over_seeds(std::uint64_t seeds, const Value& value) {
    double sum = 0.0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        sum += value(seed);
    }
    return sum / static_cast<double>(seeds);
}

TEST(ParameterSpread, IsTheVarianceThatWasPutIn) {
    for (const double chance : {0.1, 10.0, 40.0}) {
        const double variance = mean_over_seeds(200, [&](std::uint64_t seed) {
            const auto draws = unit_draws(seed);
            return parameter_spread(toy(draws, 1.0, chance, seed + 1000), draws)->variance;
        });
        // Of 64 values the variance scatters by sqrt(2 / 63) (10 + chance); 200 seeds, four deviations. The
        // floor at 0 is not met but where chance is several times the spread.
        EXPECT_NEAR(variance, 10.0, 4.0 * std::sqrt(2.0 / 63.0 / 200.0) * (10.0 + chance) + 0.02 * chance);
    }
}

/// Share of 2000 new draws inside the interval of all, by_both around the mean of all rocks.
double covered_at(double chance) {
    return mean_over_seeds(2000, [&](std::uint64_t seed) {
        const auto draws = unit_draws(seed);
        const auto figures = toy(draws, 1.0, chance, seed + 5000);
        double mean = 0.0;
        for (const StratumFigure& one : figures) {
            mean += one.value / static_cast<double>(strata);
        }
        const double half = 1.96 * std::sqrt(chance / static_cast<double>(strata));
        const Interval all = by_both(mean, {mean - half, mean + half}, *parameter_spread(figures, draws));
        config::RandomStream stream{{seed, 1, 0, 0}, config::Purpose::test};
        const double truth = 10.0 + 3.0 * config::normal(stream.uniform(), 0.0, 1.0) +
                             config::normal(stream.uniform(), 0.0, 1.0);
        return truth >= all.low && truth <= all.high ? 1.0 : 0.0;
    });
}

// 64 draws: two of them end the interval; what they leave open takes up to two percent.
const double slack = 4.0 * std::sqrt(0.95 * 0.05 / 2000.0) + 0.02;

TEST(ParameterSpread, CoversANewDrawAsOftenAsItSays) {
    for (const double chance : {0.1, 10.0}) {
        EXPECT_NEAR(covered_at(chance), 0.95, slack) << chance;
    }
}

/// Chance of 2 to 160 times the spread, as few rocks bring it, hides the spread of most samples.
TEST(ParameterSpread, CoversANewDrawWhereChanceHidesTheSpread) {
    for (const double chance : {20.0, 30.0, 40.0, 100.0, 400.0, 1600.0}) {
        EXPECT_GE(covered_at(chance), 0.95 - slack) << chance;
    }
}

TEST(ParameterSpread, HoldsWhatChanceCouldHideWhereNothingSpreads) {
    const auto draws = unit_draws(1);
    std::vector<StratumFigure> figures = toy(draws, 0.0, 1.0, 9);
    for (StratumFigure& one : figures) {
        one.value = 10.0 + 0.5 * (one.value - 10.0);  // less scatter than chance alone explains
    }
    const auto spread = parameter_spread(figures, draws);
    ASSERT_TRUE(spread);
    EXPECT_EQ(spread->variance, 0.0);
    for (const double share : spread->shares) {
        EXPECT_EQ(share, 0.0);
    }
    const Interval all = by_both(10.0, {9.7, 10.4}, *spread);
    EXPECT_LT(all.low, 9.7);
    EXPECT_GT(all.high, 10.4);
    // Of 64 equal chances the estimate has a standard error of sqrt(2 / 63) of one.
    EXPECT_NEAR(spread->offsets.high, 1.96 * std::sqrt(1.5 * std::sqrt(2.0 / 63.0)), 1e-3);
    EXPECT_EQ(spread->offsets.low, -spread->offsets.high);
    EXPECT_FALSE(spread->is_shown);
}

TEST(ParameterSpread, IsNeverNarrowerThanTheRocksAlone) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        const auto draws = unit_draws(seed);
        const auto spread = parameter_spread(toy(draws, 0.3, 2.0, seed), draws);
        const Interval all = by_both(10.0, {9.7, 10.4}, *spread);
        EXPECT_LE(all.low, 9.7);
        EXPECT_GE(all.high, 10.4);
    }
}

TEST(ParameterSpread, NamesWhatItComesFrom) {
    const auto draws = unit_draws(4);
    const std::vector<double> shares = parameter_spread(toy(draws, 1.0, 0.5, 4), draws)->shares;
    EXPECT_NEAR(shares[0], 0.9, 0.06);  // 3^2 / (3^2 + 1^2)
    EXPECT_NEAR(shares[1], 0.1, 0.06);
    EXPECT_NEAR(shares[2], 0.0, 0.03);
    EXPECT_LE(shares[0] + shares[1] + shares[2], 1.0 + 1e-12);
}

TEST(ParameterSpread, NeedsSomeStrata) {
    const auto draws = unit_draws(4);
    std::vector<StratumFigure> figures = toy(draws, 1.0, 0.5, 4);
    figures.resize(least_strata - 1);
    EXPECT_FALSE(parameter_spread(figures, draws));
}

}  // namespace
}  // namespace coupling::parameter_spread_test
