#include "rockfall/laws/rebound.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rockfall::rebound_test {
namespace {

TEST(SpeedAfter, IsThatOfBothReducedComponents) {
    const Impact impact{4.0, 3.0, Eigen::Vector3d::UnitX()};
    EXPECT_DOUBLE_EQ(speed_after(impact, {1.0, 1.0}), 5.0);
    EXPECT_DOUBLE_EQ(speed_after(impact, {0.5, 0.0}), 2.0);
    EXPECT_DOUBLE_EQ(speed_after(impact, {0.0, 0.5}), 1.5);
    EXPECT_DOUBLE_EQ(speed_after(impact, {0.3, 0.8}), std::hypot(1.2, 2.4));
}

TEST(SpeedAfter, IsBelowTheSpeedBeforeAtAnyAngle) {
    for (double angle_deg = 0.0; angle_deg <= 90.0; angle_deg += 5.0) {
        const double angle_rad = config::Angle::from_degrees(angle_deg).in_radians();
        const Impact impact{20.0 * std::sin(angle_rad), 20.0 * std::cos(angle_rad), Eigen::Vector3d::UnitX()};
        EXPECT_LE(speed_after(impact, {largest_restitution, largest_restitution}), 0.99 * 20.0 + 1e-12);
        EXPECT_GT(speed_after(impact, {0.3, 0.8}), 0.0);
    }
}

TEST(Split, PutsTheVelocityTogetherAgain) {
    const Eigen::Vector3d normal = Eigen::Vector3d{-0.5, 0.1, 0.8}.normalized();
    const Eigen::Vector3d velocity_mps{12.0, -3.0, -9.0};
    const Impact impact = split(velocity_mps, normal);
    EXPECT_GT(impact.into_ground_mps, 0.0);
    const Eigen::Vector3d again_mps =
        impact.along_slope_mps * impact.direction - impact.into_ground_mps * normal;
    EXPECT_LT((again_mps - velocity_mps).norm(), 1e-12);
}

TEST(Split, SendsARockThatFallsStraightOntoAFaceDownItsFallLine) {
    const Eigen::Vector3d normal = Eigen::Vector3d{0.6, 0.0, 0.8};
    const Impact impact = split(-5.0 * normal, normal);
    EXPECT_NEAR(impact.into_ground_mps, 5.0, 1e-12);
    EXPECT_LT((impact.direction - Eigen::Vector3d{0.8, 0.0, -0.6}).norm(), 1e-12);
    EXPECT_EQ(split({0.0, 0.0, -5.0}, Eigen::Vector3d::UnitZ()).direction, Eigen::Vector3d::UnitX());
}

TEST(Rebound, LeavesAtItsAngleWithItsSpeed) {
    const Eigen::Vector3d normal = Eigen::Vector3d{0.6, 0.0, 0.8};
    const Eigen::Vector3d down{0.8, 0.0, -0.6};
    const Eigen::Vector3d leaving_mps = rebound(7.0, config::Angle::from_degrees(30.0), down, normal);
    EXPECT_NEAR(leaving_mps.norm(), 7.0, 1e-9);
    EXPECT_NEAR(leaving_mps.dot(normal), 3.5, 1e-9);
    EXPECT_NEAR(leaving_mps.dot(down), 7.0 * std::sqrt(0.75), 1e-9);
}

}  // namespace
}  // namespace rockfall::rebound_test
