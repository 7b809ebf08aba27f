#include "forest/light/direction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace direction_test {
namespace {

using config::Angle;

TEST(TurnOf, IsSineAndCosineAllAround) {
    for (double degrees = -360.0; degrees <= 360.0; degrees += 7.5) {
        const forest::Turn turn = forest::turn_of(Angle::from_degrees(degrees));
        EXPECT_NEAR(turn.sin, std::sin(degrees * std::numbers::pi / 180.0), 1e-10) << degrees;
        EXPECT_NEAR(turn.cos, std::cos(degrees * std::numbers::pi / 180.0), 1e-10) << degrees;
    }
}

TEST(AzimuthOf, FindsTheAngleOfADirection) {
    for (double degrees = 0.0; degrees < 360.0; degrees += 3.7) {
        const forest::Direction towards =
            forest::direction_at(Angle::from_degrees(degrees), Angle::from_degrees(40.0));
        EXPECT_NEAR(forest::azimuth_of(towards.x, towards.y).in_degrees(), degrees, 1e-8);
    }
    EXPECT_EQ(forest::azimuth_of(0.0, 0.0).in_degrees(), 0.0);
}

TEST(ArcCosine, TurnsTheCosineBack) {
    for (double degrees = 0.0; degrees <= 180.0; degrees += 9.0) {
        const double cosine = std::cos(degrees * std::numbers::pi / 180.0);
        EXPECT_NEAR(forest::arc_cosine(cosine).in_degrees(), degrees, 1e-5);
    }
    EXPECT_DOUBLE_EQ(forest::arc_cosine(1.5).in_degrees(), 0.0);
}

TEST(GroundNormal, LeansTheWayTheSlopeFaces) {
    const forest::Direction normal =
        forest::ground_normal(Angle::from_degrees(35.0), Angle::from_degrees(180.0));
    EXPECT_NEAR(normal.x, 0.0, 1e-10);
    EXPECT_NEAR(normal.y, -std::sin(35.0 * std::numbers::pi / 180.0), 1e-10);
    const forest::Direction same =
        forest::ground_normal_of_gradient(0.0, std::tan(35.0 * std::numbers::pi / 180.0));
    EXPECT_NEAR(same.y, normal.y, 1e-9);
    EXPECT_NEAR(same.z, normal.z, 1e-9);
}

}  // namespace

}  // namespace direction_test
