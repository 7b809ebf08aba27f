#include "rockfall/motion/picus/jump_angle.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rockfall::picus::jump_angle_test {
namespace {

JumpAngleLaw fitted() {
    JumpAngleLaw law;
    law.scatter = 0.0;
    law.coefficient = config::Angle::from_degrees(80.0);
    return law;
}

TEST(JumpAngle, MeetsTheFittedCurve) {
    // Rammer et al. 2010, Eq. 9: 80 v^-0.74 degrees.
    for (const double speed_mps : {2.0, 3.0, 5.0, 8.0, 10.0, 15.0, 20.0, 30.0}) {
        EXPECT_NEAR(jump_angle(speed_mps * speed_mps, fitted()).in_degrees(),
                    80.0 * std::pow(speed_mps, -0.74), 1e-9)
            << speed_mps << " m/s";
    }
    EXPECT_NEAR(jump_angle(100.0, fitted()).in_degrees(), 14.56, 0.005);
    EXPECT_NEAR(jump_angle(400.0, fitted()).in_degrees(), 8.72, 0.005);
}

TEST(JumpAngle, IsCappedForSlowRocks) {
    EXPECT_DOUBLE_EQ(jump_angle(0.5 * 0.5, fitted()).in_degrees(), 60.0);
    EXPECT_DOUBLE_EQ(jump_angle(0.0, fitted()).in_degrees(), 60.0);
}

TEST(JumpAngle, ScattersByItsLogarithm) {
    JumpAngleLaw law = fitted();
    law.scatter = 0.3;
    const double mean_deg = jump_angle(100.0, law, 0.0).in_degrees();
    EXPECT_NEAR(jump_angle(100.0, law, 1.0).in_degrees(), mean_deg * std::exp(0.3), 1e-9);
    EXPECT_NEAR(jump_angle(100.0, law, -2.0).in_degrees(), mean_deg * std::exp(-0.6), 1e-9);
}

}  // namespace
}  // namespace rockfall::picus::jump_angle_test
