#include "rockfall/obstacles/tree_deviation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "rockfall/parameters.hpp"

namespace rockfall::tree_deviation_test {
namespace {

constexpr HitType all_types[] = {HitType::frontal, HitType::lateral, HitType::scratch};

config::SinCos turn_of(double angle_deg) {
    return config::sin_cos_of(config::Angle::from_degrees(angle_deg).in_radians());
}

TEST(DrawnDeviation, GoesThroughTheClassesInTheirShares) {
    const DeviationMatrix matrix = shipped_deviation_matrix();
    for (const HitType type : all_types) {
        const auto& shares = matrix.shares[static_cast<std::size_t>(type)];
        double below = 0.0;
        for (std::size_t k = 0; k < shares.size(); ++k) {
            const double class_draw = below + 0.5 * shares[k];  // in the middle of the class
            const double low_deg = matrix.limits[k].in_degrees();
            const double high_deg = matrix.limits[k + 1].in_degrees();
            EXPECT_NEAR(drawn_deviation(type, matrix, class_draw, 0.0).in_degrees(), low_deg, 1e-9);
            EXPECT_NEAR(drawn_deviation(type, matrix, class_draw, 0.5).in_degrees(),
                        0.5 * (low_deg + high_deg), 1e-9);
            below += shares[k];
        }
    }
}

TEST(DrawnDeviation, StaysWithinTheLimitsOfTheMatrix) {
    const DeviationMatrix matrix = shipped_deviation_matrix();
    for (const HitType type : all_types) {
        for (double draw = 0.0; draw < 1.0; draw += 0.01) {
            const config::Angle angle = drawn_deviation(type, matrix, draw, 1.0 - 1e-12);
            EXPECT_GE(angle.in_radians(), matrix.limits.front().in_radians());
            EXPECT_LE(angle.in_radians(), matrix.limits.back().in_radians());
        }
    }
}

TEST(LimitedTurn, KeepsATurnThatTheStemCanBringAbout) {
    // sin^2 30 = 1/4: a stem that can take a quarter of the energy turns the path by 30 degrees.
    const config::SinCos kept = limited_turn(turn_of(29.9), 25e3, 25e3, 100e3);
    EXPECT_EQ(kept.sin, turn_of(29.9).sin);
    EXPECT_EQ(kept.cos, turn_of(29.9).cos);
    EXPECT_EQ(limited_turn(turn_of(76.0), 500e3, 500e3, 100e3).sin, turn_of(76.0).sin);
}

TEST(LimitedTurn, CutsATurnOffWhereItWouldTakeAllThatTheStemCanTake) {
    const config::SinCos cut = limited_turn(turn_of(60.0), 25e3, 25e3, 100e3);
    EXPECT_NEAR(std::asin(cut.sin) * 180.0 / std::numbers::pi, 30.0, 1e-9);
    EXPECT_NEAR(cut.sin * cut.sin + cut.cos * cut.cos, 1.0, 1e-12);
}

TEST(LimitedTurn, LeavesAScratchTwoPercentOfTheStrength) {
    const config::SinCos scratch = limited_turn(turn_of(70.0), 0.0, 50e3, 100e3);
    EXPECT_NEAR(scratch.sin, std::sqrt(0.02 * 0.5), 1e-12);
}

}  // namespace
}  // namespace rockfall::tree_deviation_test
