#include "coupling/assessments/collapse/deposit.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "config/random/stream.hpp"
#include "rockfall/solids/mass_properties.hpp"
#include "rockfall/solids/shapes.hpp"

namespace coupling::collapse {
namespace {

using Eigen::Vector3d;

/// 10 x 10 cells of 2 m.
config::GridFrame frame() {
    return {10, 10, 700'000.0, 200'000.0, 2.0, 2.0};
}

double sum_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

Vector3d on_map(double east_m, double north_m, double up_m) {
    return {700'000.0 + east_m, 200'000.0 + north_m, up_m};
}

TEST(Deposit, HasOfABlockInEachCellWhatLiesThere) {
    // A box of 4 m x 3 m x 2 m over cells of 2 m: corners at 3 and 7 m east, 5 and 8 m north.
    const auto box = rockfall::solids::box({4.0, 3.0, 2.0});
    Deposit deposit{frame().size()};
    add_block(deposit, frame(), {box, on_map(5.0, 6.5, 1234.0), Eigen::Quaterniond::Identity(), 2.9});
    const auto in = [&](double east_m, double north_m) {
        return deposit.volume_m3[frame().index(frame().cell_at(700'000.0 + east_m, 200'000.0 + north_m))];
    };
    EXPECT_NEAR(in(3.5, 5.5), 1.0 * 1.0 * 2.0, 1e-9);
    EXPECT_NEAR(in(5.0, 5.5), 2.0 * 1.0 * 2.0, 1e-9);
    EXPECT_NEAR(in(6.5, 5.5), 1.0 * 1.0 * 2.0, 1e-9);
    EXPECT_NEAR(in(3.5, 7.0), 1.0 * 2.0 * 2.0, 1e-9);
    EXPECT_NEAR(in(5.0, 7.0), 2.0 * 2.0 * 2.0, 1e-9);
    EXPECT_EQ(in(1.0, 7.0), 0.0);
    EXPECT_EQ(in(5.0, 9.0), 0.0);
    EXPECT_NEAR(sum_of(deposit.volume_m3), 24.0, 1e-9);
    for (std::size_t k = 0; k < deposit.volume_m3.size(); ++k) {
        EXPECT_EQ(deposit.largest_m[k], deposit.volume_m3[k] > 0.0 ? 2.9 : 0.0);
    }
}

TEST(Deposit, HasTheVolumeOfItsBlocksHoweverTheyLie) {
    config::RandomStream draws{{3, 0, 0, 1}, config::Purpose::test};
    Deposit deposit{frame().size()};
    double volume_m3 = 0.0;
    for (int i = 0; i < 200; ++i) {
        const auto between = [&](double low, double high) { return low + (high - low) * draws.uniform(); };
        std::vector<Vector3d> points;
        for (int k = 0; k < 12; ++k) {
            points.push_back({between(-2.0, 2.0), between(-2.0, 2.0), between(-1.0, 1.0)});
        }
        const auto solid = rockfall::solids::solid_of(rockfall::solids::convex_hull(points), 2700.0);
        const Eigen::Quaterniond turn{between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0),
                                      between(-1.0, 1.0)};
        // No corner is farther than 6 m from the centre.
        add_block(
            deposit, frame(),
            {solid.hull, on_map(between(6.0, 14.0), between(6.0, 14.0), 800.0), turn.normalized(), 1.0});
        volume_m3 += solid.volume_m3;
    }
    // Coordinates of 700 km have 1e-10 m; of 200 blocks of some 10 m3 that is 1e-8 m3 at most.
    EXPECT_NEAR(sum_of(deposit.volume_m3), volume_m3, 1e-7);
    for (const double volume : deposit.volume_m3) {
        EXPECT_GE(volume, 0.0);
    }
}

TEST(Deposit, LosesWhatLiesBeyondTheMap) {
    const auto cube = rockfall::solids::box(Vector3d::Constant(2.0));
    Deposit deposit{frame().size()};
    add_block(deposit, frame(), {cube, on_map(0.0, 10.0, 5.0), Eigen::Quaterniond::Identity(), 2.0});
    EXPECT_NEAR(sum_of(deposit.volume_m3), 4.0, 1e-9);  // half of it
    add_block(deposit, frame(), {cube, on_map(-5.0, 10.0, 5.0), Eigen::Quaterniond::Identity(), 2.0});
    EXPECT_NEAR(sum_of(deposit.volume_m3), 4.0, 1e-9);
}

}  // namespace
}  // namespace coupling::collapse
