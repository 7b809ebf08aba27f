#include "rockfall/laws/on_face.hpp"

#include <gtest/gtest.h>

namespace rockfall::on_face_test {
namespace {

/// A face that falls by 3 in 4 along x.
const Plane face{Eigen::Vector3d{10.0, 20.0, 500.0}, Eigen::Vector2d{-0.75, 0.0}};
const Eigen::Vector3d down = Eigen::Vector3d{0.8, 0.0, -0.6};

TEST(LaidInto, KeepsSpeedAndTurnsStraightOntoTheFace) {
    // 4 m/s down the fall line and 3 m/s into the face: 5 m/s down the fall line.
    const Eigen::Vector3d laid_mps = laid_into(face.normal(), 4.0 * down - 3.0 * face.normal());
    EXPECT_LT((laid_mps - 5.0 * down).norm(), 1e-9);
    EXPECT_EQ(laid_into(face.normal(), Eigen::Vector3d::Zero()), Eigen::Vector3d::Zero());
}

TEST(RisingWith, KeepsSpeedAndHeading) {
    const Eigen::Vector3d level_mps{3.0, 4.0, 0.0};
    const Eigen::Vector3d tilted_mps = rising_with(face, level_mps);
    EXPECT_NEAR(tilted_mps.norm(), 5.0, 1e-12);
    EXPECT_NEAR(tilted_mps.dot(face.normal()), 0.0, 1e-9);
    EXPECT_NEAR(tilted_mps.y() / tilted_mps.x(), 4.0 / 3.0, 1e-12);
    EXPECT_EQ(rising_with(face, Eigen::Vector3d::Zero()), Eigen::Vector3d::Zero());
}

TEST(TurnedInPlan, GoesCounterClockwiseAndLeavesTheRise) {
    const Eigen::Vector3d turned_mps = turned_in_plan({3.0, 4.0, -2.0}, {1.0, 0.0});
    EXPECT_EQ(turned_mps, (Eigen::Vector3d{-4.0, 3.0, -2.0}));
}

}  // namespace
}  // namespace rockfall::on_face_test
