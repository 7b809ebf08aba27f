#include "forest/light/optical_depth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/forest/light/stands.hpp"

namespace optical_depth_test {
namespace {

using forest::Canopy;
using forest::Direction;
using forest::LightGround;
using forest::PaddedGround;
using forest::PrefixSums;
using forest::RayWalk;

constexpr double reach_m = 300.0;

PaddedGround padded(const LightGround& ground) {
    return {ground, static_cast<int>(reach_m / 10.0) + 2};
}

RayWalk walk(const PaddedGround& ground, const Direction& towards, double x_m = 0.0, double y_m = 0.0) {
    return forest::walk_towards(towards, x_m, y_m, 10.0, ground.stride(), reach_m + 60.0, reach_m);
}

TEST(ExpMinus, IsTheExponential) {
    for (float x = 0.0F; x < 79.0F; x += 0.0371F) {
        EXPECT_NEAR(forest::exp_minus(x) / std::exp(-static_cast<double>(x)), 1.0, 5e-6) << x;
    }
    EXPECT_GT(forest::exp_minus(1e30F), 0.0F);
}

TEST(CastColumn, IsBeersLawUnderEvenLeavesOnEverySlope) {
    constexpr double leaf_area_index = 3.0;
    constexpr double extinction = 0.5;
    constexpr int layers = 6;
    for (const double rise_x : {0.0, 0.5}) {
        for (const double rise_y : {0.0, -0.7}) {
            const PaddedGround ground = padded(stands::plane(4, 4, rise_x, rise_y));
            const Canopy canopy{ground,
                                stands::even_leaves(ground.frame(), leaf_area_index, layers, extinction)};
            for (double azimuth_deg = 0.0; azimuth_deg < 360.0; azimuth_deg += 22.5) {
                for (const double elevation_deg : {25.0, 45.0, 70.0, 90.0}) {
                    const Direction towards = forest::direction_at(
                        config::Angle::from_degrees(azimuth_deg), config::Angle::from_degrees(elevation_deg));
                    // Gain of height above the ground per metre of the ray.
                    const double climb = towards.z - rise_x * towards.x - rise_y * towards.y;
                    if (climb < 0.15) {
                        continue;  // out of reach before it leaves the canopy, or into the slope
                    }
                    const auto depth = forest::column_depth<forest::canopy_layers>(
                        ground, canopy.leaf_on(), canopy.top_m(), walk(ground, towards), ground.padded(5));
                    const double through_all = extinction * leaf_area_index / climb;
                    EXPECT_NEAR(depth.ground / through_all, 1.0, 2e-3);
                    for (std::size_t l = 0; l < layers; ++l) {
                        const double above = 1.0 - (static_cast<double>(l) + 0.5) / layers;
                        EXPECT_NEAR(depth.layers[l] / (above * through_all), 1.0, 4e-3);
                    }
                    EXPECT_NEAR(depth.layers[layers], 0.0, 1e-4);
                }
            }
        }
    }
}

/// Optical depth by steps of 2 cm, looked up where each step lies.
double marched(const PaddedGround& ground, const Canopy& canopy, double rise_x, double rise_y,
               std::size_t column, double height_m, const Direction& towards) {
    constexpr double step_m = 0.02;
    const config::GridFrame& frame = ground.frame();
    const config::Cell start = frame.cell_of(column);
    double tau = 0.0;
    for (double gone_m = 0.5 * step_m; gone_m * std::sqrt(1.0 - towards.z * towards.z) < reach_m;
         gone_m += step_m) {
        const double x_m = gone_m * towards.x;
        const double y_m = gone_m * towards.y;
        const double above_m = height_m + gone_m * towards.z - rise_x * x_m - rise_y * y_m;
        if (above_m > 60.0) {
            break;
        }
        const auto wrapped = [](int place, int count) { return (place % count + count) % count; };
        const int across = static_cast<int>(std::floor(frame.x_centre_m(start.column) / 10.0 + x_m / 10.0));
        const int down =
            frame.rows - 1 - static_cast<int>(std::floor(frame.y_centre_m(start.row) / 10.0 + y_m / 10.0));
        const std::size_t there = frame.index({wrapped(across, frame.columns), wrapped(down, frame.rows)});
        const float* nodes = canopy.leaf_on().of(ground.padded(there)) + PrefixSums::nodes_below;
        const auto layer = static_cast<std::size_t>(above_m / 5.0);
        tau += step_m * static_cast<double>(nodes[layer + 1] - nodes[layer]) / 5.0;
    }
    return tau;
}

TEST(CastColumn, FindsWhatSmallStepsFind) {
    config::RandomStream stream{{17, 0, 0, 0}, config::Purpose::test};
    for (const double rise_y : {0.0, 0.6}) {
        const PaddedGround ground = padded(stands::plane(6, 5, 0.1, rise_y));
        const auto trees = stands::random_trees(stream, 60, 60.0, 50.0);
        const Canopy canopy{ground, trees};
        for (const auto& [azimuth_deg, elevation_deg] :
             {std::pair{200.0, 20.0}, {93.0, 35.0}, {310.0, 50.0}, {180.0, 80.0}}) {
            const Direction towards = forest::direction_at(config::Angle::from_degrees(azimuth_deg),
                                                           config::Angle::from_degrees(elevation_deg));
            const std::size_t column = 8;
            const auto depth = forest::column_depth<forest::canopy_layers>(
                ground, canopy.leaf_on(), canopy.top_m(), walk(ground, towards), ground.padded(column));
            const double on_ground = marched(ground, canopy, 0.1, rise_y, column, 0.0, towards);
            EXPECT_NEAR(depth.ground, on_ground, 0.005 + 0.005 * on_ground);
            for (const std::size_t l : {0UL, 3UL, 6UL}) {
                const double expected = marched(ground, canopy, 0.1, rise_y, column,
                                                5.0 * (static_cast<double>(l) + 0.5), towards);
                EXPECT_NEAR(depth.layers[l], expected, 0.005 + 0.005 * expected);
            }
        }
    }
}

TEST(CastGround, IsTheGroundOfTheColumnAtItsCentre) {
    config::RandomStream stream{{18, 0, 0, 0}, config::Purpose::test};
    const PaddedGround ground = padded(stands::plane(6, 6, 0.2, 0.3));
    const auto trees = stands::random_trees(stream, 50, 60.0, 60.0);
    const Canopy canopy{ground, trees};
    const RayWalk way = walk(
        ground, forest::direction_at(config::Angle::from_degrees(120.0), config::Angle::from_degrees(30.0)));
    for (std::size_t column = 0; column < ground.frame().size(); ++column) {
        const std::size_t at = ground.padded(column);
        EXPECT_NEAR(
            ground_depth(ground, canopy.leaf_on(), canopy.top_m(), way, at, 1e9F),
            forest::column_depth<forest::canopy_layers>(ground, canopy.leaf_on(), canopy.top_m(), way, at)
                .ground,
            1e-4);
    }
}

TEST(CastColumn, EndsInRisingGround) {
    LightGround valley = stands::plane(20, 3, 0.0, 0.0, forest::Edges::open);
    for (int row = 0; row < 3; ++row) {
        for (int column = 12; column < 20; ++column) {
            valley.elevation_m.at({column, row}) = 40.0;
        }
    }
    const PaddedGround ground = padded(valley);
    const Canopy canopy{ground, {}};
    const std::size_t at = ground.padded(valley.elevation_m.frame.index({8, 1}));
    const RayWalk east = walk(
        ground, forest::direction_at(config::Angle::from_degrees(90.0), config::Angle::from_degrees(30.0)));
    const auto depth = forest::column_depth<forest::canopy_layers>(ground, canopy.leaf_on(), 60.0, east, at);
    EXPECT_LT(forest::exp_minus(depth.ground), 1e-6F);
    EXPECT_LT(forest::exp_minus(depth.layers[1]), 1e-6F);
    EXPECT_EQ(depth.layers[8], 0.0F);  // 42 m up it passes above
}

}  // namespace

}  // namespace optical_depth_test
