#include "rockfall/motion/picus/normal_damping.hpp"

#include <gtest/gtest.h>

namespace rockfall::picus::normal_damping_test {
namespace {

constexpr Restitution meadow{0.30, 0.82};

TEST(AtNormalSpeed, HalvesTheNormalCoefficientAtThirtyFeetASecond) {
    // Pfeiffer & Bowen (1989): 1 / (1 + (v_n / 30 ft/s)^2); a foot has 0.3048 m.
    constexpr double halved_mps = pfeiffer_bowen_mps;
    EXPECT_DOUBLE_EQ(halved_mps, 9.144);
    EXPECT_DOUBLE_EQ(at_normal_speed(meadow, halved_mps, halved_mps).normal, 0.15);
    EXPECT_DOUBLE_EQ(at_normal_speed(meadow, 3.0 * halved_mps, halved_mps).normal, 0.03);
}

TEST(AtNormalSpeed, LeavesTheTangentialCoefficient) {
    EXPECT_EQ(at_normal_speed(meadow, 20.0, 9.144).tangential, meadow.tangential);
}

TEST(AtNormalSpeed, KeepsSlowImpactsAndAllIfItIsOff) {
    EXPECT_EQ(at_normal_speed(meadow, 0.0, 9.144).normal, meadow.normal);
    EXPECT_EQ(at_normal_speed(meadow, 50.0, 0.0).normal, meadow.normal);
}

TEST(AtNormalSpeed, LetsNoReboundGrowBeyondThatOfTheHalvingSpeed) {
    // The speed off the ground, r_n v / (1 + (v / h)^2), is greatest at v = h.
    const double greatest_mps = at_normal_speed(meadow, 9.144, 9.144).normal * 9.144;
    for (double into_ground_mps = 0.5; into_ground_mps < 60.0; into_ground_mps += 0.5) {
        EXPECT_LE(at_normal_speed(meadow, into_ground_mps, 9.144).normal * into_ground_mps,
                  greatest_mps * (1.0 + 1e-12))
            << into_ground_mps;
    }
}

}  // namespace
}  // namespace rockfall::picus::normal_damping_test
