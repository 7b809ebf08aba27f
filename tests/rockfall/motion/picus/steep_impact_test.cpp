#include "rockfall/motion/picus/steep_impact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rockfall::picus::steep_impact_test {
namespace {

/// An impact at an angle to the plane.
Impact impact_at(double angle_deg, double speed_mps = 20.0) {
    const double angle_rad = config::Angle::from_degrees(angle_deg).in_radians();
    return {speed_mps * std::sin(angle_rad), speed_mps * std::cos(angle_rad), Eigen::Vector3d::UnitX()};
}

TEST(SteepnessShare, RisesFromNoneAt60ToAllAt85Degrees) {
    for (const double angle_deg : {0.0, 20.0, 45.0, 59.99}) {
        EXPECT_EQ(steepness_share(impact_at(angle_deg)), 0.0) << angle_deg;
    }
    EXPECT_NEAR(steepness_share(impact_at(60.0)), 0.0, 1e-9);
    EXPECT_NEAR(steepness_share(impact_at(85.0)), 1.0, 1e-9);
    EXPECT_EQ(steepness_share(impact_at(90.0)), 1.0);
    double before = 0.0;
    for (double angle_deg = 61.0; angle_deg < 85.0; angle_deg += 1.0) {
        const double share = steepness_share(impact_at(angle_deg));
        EXPECT_GT(share, before) << angle_deg;
        before = share;
    }
}

TEST(SteepnessShare, IsLinearInTheSineAndHasNoSpeedInIt) {
    const double middle_sine =
        0.5 * (std::sin(std::numbers::pi / 3.0) + std::sin(85.0 / 180.0 * std::numbers::pi));
    const double middle_deg = std::asin(middle_sine) * 180.0 / std::numbers::pi;
    for (const double speed_mps : {1e-3, 1.0, 20.0, 90.0}) {
        EXPECT_NEAR(steepness_share(impact_at(middle_deg, speed_mps)), 0.5, 1e-12) << speed_mps;
    }
    EXPECT_EQ(steepness_share({0.0, 0.0, Eigen::Vector3d::UnitX()}), 0.0);
}

TEST(BlendedDirection, GoesFromTheAngleOfTheLawToTheGeometricOne) {
    const config::Angle law = config::Angle::from_degrees(10.0);
    const Impact impact = impact_at(80.0);
    const Restitution restitution{0.3, 0.8};
    const Eigen::Vector2d none = blended_direction(law, impact, restitution, 0.0);
    EXPECT_NEAR(std::atan2(none.y(), none.x()) * 180.0 / std::numbers::pi, 10.0, 1e-9);
    const Eigen::Vector2d all = blended_direction(law, impact, restitution, 1.0);
    EXPECT_NEAR(all.y() / all.x(), 0.3 * impact.into_ground_mps / (0.8 * impact.along_slope_mps), 1e-12);
    double before = 0.0;
    for (double share = 0.0; share <= 1.0; share += 0.125) {
        const Eigen::Vector2d blend = blended_direction(law, impact, restitution, share);
        EXPECT_NEAR(blend.norm(), 1.0, 1e-12) << share;
        EXPECT_GT(blend.y() / blend.x(), before) << share;
        before = blend.y() / blend.x();
    }
}

TEST(BlendedDirection, KeepsTheAngleOfTheLawWhereNothingIsLeftOfTheSpeed) {
    const config::Angle law = config::Angle::from_degrees(60.0);
    const Eigen::Vector2d direction = blended_direction(law, impact_at(90.0), {0.0, 0.0}, 1.0);
    EXPECT_NEAR(direction.x(), 0.5, 1e-10);
    EXPECT_GT(direction.y(), 0.0);
}

}  // namespace
}  // namespace rockfall::picus::steep_impact_test
