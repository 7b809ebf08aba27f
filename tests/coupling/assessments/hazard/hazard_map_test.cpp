#include "coupling/assessments/hazard/hazard_map.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "rockfall/tally/cell_releases.hpp"

namespace coupling::hazard::hazard_map_test {
namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();

config::GridFrame frame_of(int columns, int rows) {
    config::GridFrame frame;
    frame.columns = columns;
    frame.rows = rows;
    frame.x_west_m = 0.0;
    frame.y_south_m = 0.0;
    frame.cell_width_m = 10.0;
    frame.cell_height_m = 10.0;
    return frame;
}

/// Of 1000 rocks; all of a cell have one energy, and all sources feed it.
PeriodFalls falls_of(double years, std::vector<float> energy_kj, std::vector<float> reach_percent) {
    const config::GridFrame frame = frame_of(static_cast<int>(energy_kj.size()), 1);
    const config::Raster<float> empty{frame, none};
    PeriodFalls falls{years, empty, empty, empty, empty, {}};
    for (const float from_j : rockfall::CellReleases::from_j) {
        config::Raster<float>& from = falls.per_release.emplace_back(empty);
        for (std::size_t i = 0; i < energy_kj.size(); ++i) {
            if (!std::isnan(energy_kj[i])) {
                from.values[i] = 1000.0F * energy_kj[i] >= from_j ? reach_percent[i] / 100.0F : 0.0F;
            }
        }
    }
    for (std::size_t i = 0; i < energy_kj.size(); ++i) {
        falls.passages.values[i] = 10.0F * reach_percent[i];
    }
    falls.largest_kj.values = energy_kj;
    falls.energy_kj.values = std::move(energy_kj);
    falls.reach_percent.values = std::move(reach_percent);
    return falls;
}

float number(Level level) {
    return static_cast<float>(level);
}

TEST(HazardMap, TakesTheHighestLevelOfAllReturnPeriods) {
    const std::vector<PeriodFalls> falls{
        falls_of(10.0, {20.0F, none, 20.0F, none}, {50.0F, none, 50.0F, none}),
        falls_of(100.0, {100.0F, 20.0F, 20.0F, none}, {50.0F, 50.0F, 50.0F, none}),
        falls_of(300.0, {400.0F, 100.0F, 25.0F, none}, {50.0F, 50.0F, 50.0F, none})};
    const HazardMap map = hazard_map(HazardRule::release, falls, Matrix::shipped(), 0.0);
    EXPECT_EQ(map.level.values[0], number(Level::high));
    EXPECT_EQ(map.rocks.values[0], 500.0F);
    EXPECT_EQ(map.ruling_years.values[0], 300.0F);
    EXPECT_EQ(map.level.values[1], number(Level::moderate));
    EXPECT_EQ(map.ruling_years.values[1], 300.0F);
    EXPECT_EQ(map.level.values[2], number(Level::moderate));  // weak, but every ten years
    EXPECT_EQ(map.ruling_years.values[2], 10.0F);
    EXPECT_TRUE(std::isnan(map.level.values[3]));
    EXPECT_TRUE(std::isnan(map.ruling_years.values[3]));
    EXPECT_EQ(map.intensity[2].values[0], 3.0F);
    EXPECT_TRUE(std::isnan(map.intensity[0].values[1]));
}

TEST(HazardMap, NamesTheShortestOfEqualReturnPeriods) {
    const std::vector<PeriodFalls> falls{falls_of(300.0, {500.0F}, {1.0F}), falls_of(30.0, {500.0F}, {1.0F})};
    EXPECT_EQ(hazard_map(HazardRule::release, falls, Matrix::shipped(), 0.0).ruling_years.values[0], 30.0F);
}

TEST(HazardMap, LeavesOutCellsThatTooFewRocksReach) {
    const std::vector<PeriodFalls> falls{falls_of(30.0, {500.0F, 500.0F}, {0.9F, 1.0F})};
    const HazardMap map = hazard_map(HazardRule::release, falls, Matrix::shipped(), 1.0);
    EXPECT_TRUE(std::isnan(map.level.values[0]));
    EXPECT_TRUE(std::isnan(map.intensity[0].values[0]));
    EXPECT_EQ(map.level.values[1], number(Level::high));
}

/// More energy, more rocks or one more return period never make a place safer, by no rule.
TEST(HazardMap, OnlyRisesWithEnergyRocksAndReturnPeriods) {
    EXPECT_TRUE(rc::check([] {
        const auto energies = *rc::gen::container<std::vector<int>>(3, rc::gen::inRange(0, 900));
        const auto years = *rc::gen::container<std::vector<int>>(3, rc::gen::inRange(1, 600));
        const auto reach = *rc::gen::container<std::vector<int>>(3, rc::gen::inRange(1, 90));
        const int more_kj = *rc::gen::inRange(0, 500);
        const HazardRule rule =
            *rc::gen::element(HazardRule::cadanav, HazardRule::arrival, HazardRule::release);
        const auto level = [&](const std::vector<PeriodFalls>& falls, std::size_t count) {
            return hazard_map(rule, std::span{falls}.first(count), Matrix::shipped(), 0.0).level.values[0];
        };
        const auto all_of = [&](int more, int more_percent) {
            std::vector<PeriodFalls> falls;
            for (std::size_t i = 0; i < 3; ++i) {
                falls.push_back(falls_of(years[i], {static_cast<float>(energies[i] + more)},
                                         {static_cast<float>(reach[i] + more_percent)}));
            }
            return falls;
        };
        const std::vector<PeriodFalls> falls = all_of(0, 0);
        RC_ASSERT(level(falls, 2) <= level(falls, 3));
        RC_ASSERT(level(all_of(more_kj, 0), 3) >= level(falls, 3));
        RC_ASSERT(level(all_of(0, 10), 3) >= level(falls, 3));
    }));
}

/// One rock in a thousand that is released once in 100 years arrives once in 100 000 years.
TEST(HazardMap, JudgesBySwitzerlandHowOftenRocksArrive) {
    const std::vector<PeriodFalls> falls{
        falls_of(30.0, {500.0F, 500.0F, 500.0F, none}, {100.0F, 30.0F, 0.1F, none})};
    const HazardMap map = hazard_map(HazardRule::cadanav, falls, Matrix::shipped(), 0.0);
    EXPECT_EQ(map.level.values[0], number(Level::high));
    EXPECT_EQ(map.level.values[1], number(Level::high));  // once in 100 years, 300 kJ and more
    EXPECT_EQ(map.level.values[2], number(Level::residual));
    EXPECT_TRUE(std::isnan(map.level.values[3]));
    EXPECT_NEAR(map.arrival_years[0].values[1], 100.0F, 1e-3F);
    EXPECT_EQ(hazard_map(HazardRule::release, falls, Matrix::shipped(), 0.0).level.values[2],
              number(Level::high));
}

TEST(PerReleaseFrom, IsExactAtTheEnergiesThatAreCountedAndFallsBetween) {
    const std::array counted{0.5, 0.4, 0.3, 0.2, 0.1};  // from 0, 30, 100, 300, 1000 kJ on
    EXPECT_EQ(per_release_from(0.0, counted, 2000.0), 0.5);
    EXPECT_EQ(per_release_from(30.0, counted, 2000.0), 0.4);
    EXPECT_EQ(per_release_from(1000.0, counted, 2000.0), 0.1);
    EXPECT_NEAR(per_release_from(15.0, counted, 2000.0), 0.45, 1e-12);
    EXPECT_NEAR(per_release_from(1500.0, counted, 2000.0), 0.05, 1e-12);
    EXPECT_EQ(per_release_from(2001.0, counted, 2000.0), 0.0);
    double before = 1.0;
    for (double energy_kj = 0.0; energy_kj < 2500.0; energy_kj += 10.0) {
        const double here = per_release_from(energy_kj, counted, 2000.0);
        EXPECT_LE(here, before) << energy_kj;
        before = here;
    }
}

}  // namespace
}  // namespace coupling::hazard::hazard_map_test
