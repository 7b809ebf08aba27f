#include "rockfall/obstacles/tree_energy.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rockfall::tree_energy_test {
namespace {

TEST(LargestEnergy, IsInJoules) {
    // Rammer et al. 2010, Eq. 1, DBH in cm; the unit settled in joules.
    EXPECT_NEAR(largest_energy_j(40.0, 1.0), 194.3e3, 50.0);
    EXPECT_NEAR(largest_energy_j(31.0, 1.0), 108e3, 500.0);
    EXPECT_NEAR(largest_energy_j(60.0, 1.0), 496e3, 500.0);
    EXPECT_DOUBLE_EQ(largest_energy_j(40.0, 1.7), 1.7 * largest_energy_j(40.0, 1.0));
}

TEST(UsableShare, FollowsTheSigmoid) {
    EXPECT_NEAR(usable_share(0.0), 0.98, 5e-4);
    EXPECT_NEAR(usable_share(0.5), 0.789, 5e-4);
    EXPECT_NEAR(usable_share(0.58), 0.467, 5e-4);
    EXPECT_EQ(usable_share(0.8), 0.0);
    EXPECT_EQ(usable_share(1.0), 0.0);
}

TEST(UsableShare, AveragesAsPublished) {
    constexpr int steps = 100'000;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        sum += usable_share((i + 0.5) / steps);
    }
    EXPECT_NEAR(sum / steps, 0.558, 5e-4);
}

TEST(UsableShare, NeverRisesFromTheCentreToTheEdge) {
    double before = 1.0;
    for (double position = 0.0; position <= 1.0; position += 0.01) {
        EXPECT_LE(usable_share(position), before) << position;
        before = usable_share(position);
    }
    EXPECT_GT(usable_share(0.745), 0.0);
    EXPECT_EQ(usable_share(0.7465), 0.0);
}

TEST(EnergyAt, FollowsThePowerOfTheDiameterAtEveryHeight) {
    const double breast_height_j = largest_energy_j(40.0, 1.0);
    EXPECT_DOUBLE_EQ(energy_at_j(breast_height_j, 1.0), breast_height_j);
    EXPECT_NEAR(energy_at_j(breast_height_j, 0.5), largest_energy_j(20.0, 1.0), 1e-6);
    EXPECT_EQ(energy_at_j(breast_height_j, 0.0), 0.0);
}

}  // namespace
}  // namespace rockfall::tree_energy_test
