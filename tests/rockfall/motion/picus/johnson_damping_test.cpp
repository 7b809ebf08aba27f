#include "rockfall/motion/picus/johnson_damping.hpp"

#include <gtest/gtest.h>

namespace rockfall::picus::johnson_damping_test {
namespace {

constexpr Restitution fine_debris{0.30, 0.75};

TEST(AtImpactSpeed, KeepsPublishedValuesUpToTheReferenceSpeed) {
    EXPECT_EQ(at_impact_speed(fine_debris, 4.0 * 4.0).normal, 0.30);
    EXPECT_EQ(at_impact_speed(fine_debris, 10.0 * 10.0).tangential, 0.75);
}

TEST(AtImpactSpeed, HalvesAtSixteenTimesTheReferenceSpeed) {
    // (1/16)^(1/4) = 1/2
    EXPECT_DOUBLE_EQ(at_impact_speed(fine_debris, 160.0 * 160.0).normal, 0.15);
}

TEST(AtImpactSpeed, MeetsThePublishedFactors) {
    // Rammer et al. 2010, Eqs. 7-8; factors of the fourth root to four digits.
    EXPECT_NEAR(at_impact_speed({1.0, 1.0}, 15.0 * 15.0).normal, 0.9036, 5e-5);
    EXPECT_NEAR(at_impact_speed({1.0, 1.0}, 20.0 * 20.0).normal, 0.8409, 5e-5);
    EXPECT_NEAR(at_impact_speed({1.0, 1.0}, 25.0 * 25.0).tangential, 0.7953, 5e-5);
    EXPECT_NEAR(at_impact_speed({1.0, 1.0}, 30.0 * 30.0).tangential, 0.7598, 5e-5);
}

TEST(AtImpactSpeed, FallsWithSpeedInBothComponentsAlike) {
    Restitution before = fine_debris;
    for (double speed_mps = 11.0; speed_mps < 80.0; speed_mps += 1.0) {
        const Restitution now = at_impact_speed(fine_debris, speed_mps * speed_mps);
        EXPECT_LT(now.normal, before.normal) << speed_mps;
        EXPECT_NEAR(now.tangential / now.normal, fine_debris.tangential / fine_debris.normal, 1e-12);
        before = now;
    }
}

}  // namespace
}  // namespace rockfall::picus::johnson_damping_test
