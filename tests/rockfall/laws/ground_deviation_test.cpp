#include "rockfall/laws/ground_deviation.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace rockfall::ground_deviation_test {
namespace {

TEST(LargestDeviation, FallsLinearlyWithSpeedAndThenStays) {
    const LateralDeviation law;  // 16 degrees at rest, 11 from 10 m/s on
    EXPECT_NEAR(largest_deviation(0.0, law).in_degrees(), 16.0, 1e-12);
    EXPECT_NEAR(largest_deviation(5.0, law).in_degrees(), 13.5, 1e-12);
    EXPECT_NEAR(largest_deviation(10.0, law).in_degrees(), 11.0, 1e-12);
    EXPECT_NEAR(largest_deviation(45.0, law).in_degrees(), 11.0, 1e-12);
}

TEST(LargestDeviation, IsNoneWhereItsAnglesAreZero) {
    const LateralDeviation none{config::Angle{}, config::Angle{}, 10.0};
    for (const double speed_mps : {0.0, 3.0, 30.0}) {
        EXPECT_EQ(largest_deviation(speed_mps, none).in_radians(), 0.0);
    }
}

TEST(Turned, GoesCounterClockwiseAboutTheNormal) {
    const Eigen::Vector3d east = Eigen::Vector3d::UnitX();
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d turned_30 = turned(east, up, config::Angle::from_degrees(30.0));
    EXPECT_NEAR(turned_30.x(), std::sqrt(0.75), 1e-11);
    EXPECT_NEAR(turned_30.y(), 0.5, 1e-11);
    EXPECT_EQ(turned(east, up, config::Angle{}), east);
}

TEST(Turned, StaysInThePlaneAndKeepsItsLength) {
    const Eigen::Vector3d normal = Eigen::Vector3d{0.3, -0.2, 0.9}.normalized();
    const Eigen::Vector3d direction = normal.cross(Eigen::Vector3d::UnitX()).normalized();
    for (const double angle_deg : {-16.0, -3.0, 0.5, 11.0, 60.0}) {
        const Eigen::Vector3d now = turned(direction, normal, config::Angle::from_degrees(angle_deg));
        EXPECT_NEAR(now.norm(), 1.0, 1e-10);
        EXPECT_NEAR(now.dot(normal), 0.0, 1e-12);
        EXPECT_NEAR(std::acos(now.dot(direction)) * 180.0 / std::numbers::pi, std::abs(angle_deg), 1e-6);
    }
}

}  // namespace
}  // namespace rockfall::ground_deviation_test
