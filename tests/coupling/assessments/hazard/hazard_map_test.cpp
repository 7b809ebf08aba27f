#include "coupling/assessments/hazard/hazard_map.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

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

PeriodFalls falls_of(double years, std::vector<float> energy_kj, std::vector<float> reach_percent) {
    const config::GridFrame frame = frame_of(static_cast<int>(energy_kj.size()), 1);
    PeriodFalls falls{years, config::Raster<float>{frame}, config::Raster<float>{frame}};
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
    const HazardMap map = hazard_map(falls, Matrix::shipped(), 0.0);
    EXPECT_EQ(map.level.values[0], number(Level::high));
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
    EXPECT_EQ(hazard_map(falls, Matrix::shipped(), 0.0).ruling_years.values[0], 30.0F);
}

TEST(HazardMap, LeavesOutCellsThatTooFewRocksReach) {
    const std::vector<PeriodFalls> falls{falls_of(30.0, {500.0F, 500.0F}, {0.9F, 1.0F})};
    const HazardMap map = hazard_map(falls, Matrix::shipped(), 1.0);
    EXPECT_TRUE(std::isnan(map.level.values[0]));
    EXPECT_TRUE(std::isnan(map.intensity[0].values[0]));
    EXPECT_EQ(map.level.values[1], number(Level::high));
}

/// More energy, or one more return period, never makes a place safer.
TEST(HazardMap, OnlyRisesWithEnergyAndWithReturnPeriods) {
    EXPECT_TRUE(rc::check([] {
        const auto energies = *rc::gen::container<std::vector<int>>(3, rc::gen::inRange(0, 900));
        const auto years = *rc::gen::container<std::vector<int>>(3, rc::gen::inRange(1, 600));
        const int more_kj = *rc::gen::inRange(0, 500);
        std::vector<PeriodFalls> falls;
        for (std::size_t i = 0; i < 3; ++i) {
            falls.push_back(falls_of(years[i], {static_cast<float>(energies[i])}, {5.0F}));
        }
        const Matrix matrix = Matrix::shipped();
        const float all = hazard_map(falls, matrix, 0.0).level.values[0];
        const float two = hazard_map(std::span{falls}.first(2), matrix, 0.0).level.values[0];
        RC_ASSERT(two <= all);
        falls[0].energy_kj.values[0] += static_cast<float>(more_kj);
        RC_ASSERT(hazard_map(falls, matrix, 0.0).level.values[0] >= all);
    }));
}

rockfall::Target line_of(std::vector<Eigen::Vector2d> points) {
    rockfall::Target target;
    target.parts.push_back(std::move(points));
    return rockfall::with_bounds(target);
}

double sum_of(const std::vector<TargetPart>& parts) {
    return std::accumulate(parts.begin(), parts.end(), 0.0,
                           [](double sum, const TargetPart& part) { return sum + part.extent; });
}

TEST(PartsOf, ALineHaveItsLengthOnTheFrame) {
    const config::GridFrame frame = frame_of(4, 2);
    const std::vector<TargetPart> parts = parts_of(line_of({{-5.0, 5.0}, {25.0, 5.0}}), frame);
    ASSERT_EQ(parts.size(), 3U);
    EXPECT_NEAR(parts[0].extent, 10.0, 0.5);  // the line is looked at in steps of half a metre
    EXPECT_NEAR(parts[1].extent, 10.0, 0.5);
    EXPECT_NEAR(parts[2].extent, 5.0, 0.5);
    EXPECT_EQ(parts[0].cell, 4U);  // southern row
    EXPECT_NEAR(sum_of(parts_of(line_of({{2.0, 3.0}, {37.0, 17.0}}), frame)), std::hypot(35.0, 14.0), 1e-9);
}

TEST(PartsOf, AnAreaHaveItsAreaOnTheFrame) {
    rockfall::Target house = line_of({{5.0, 5.0}, {20.0, 5.0}, {20.0, 15.0}, {5.0, 15.0}, {5.0, 5.0}});
    house.is_area = true;
    const std::vector<TargetPart> parts = parts_of(house, frame_of(4, 2));
    EXPECT_EQ(parts.size(), 4U);
    EXPECT_NEAR(sum_of(parts), 150.0, 1e-9);
    rockfall::Target shed = line_of({{1.0, 1.0}, {1.2, 1.0}, {1.2, 1.2}, {1.0, 1.2}, {1.0, 1.0}});
    shed.is_area = true;
    EXPECT_EQ(parts_of(shed, frame_of(4, 2)).size(), 1U);
    rockfall::Target elsewhere = line_of({{900.0, 5.0}, {920.0, 5.0}});
    EXPECT_TRUE(parts_of(elsewhere, frame_of(4, 2)).empty());
}

TEST(SharesOf, ATargetAddUpToOne) {
    config::Raster<float> levels{frame_of(4, 1)};
    levels.values = {4.0F, none, 4.0F, 2.0F};
    const std::vector<TargetPart> parts = parts_of(line_of({{0.0, 5.0}, {40.0, 5.0}}), levels.frame);
    const std::vector<double> shares = shares_of(parts, levels, 5);
    EXPECT_NEAR(shares[4], 0.5, 1e-9);
    EXPECT_NEAR(shares[2], 0.25, 1e-9);
    EXPECT_NEAR(shares[0], 0.25, 1e-9);
    EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1.0, 1e-12);
}

}  // namespace
}  // namespace coupling::hazard::hazard_map_test
