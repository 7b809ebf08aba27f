#include "forest/climate/normal.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace forest::normal_test {
namespace {

TEST(NormalProbability, AgreesWithTheErrorFunction) {
    for (double z = -9.0; z <= 9.0; z += 0.037) {
        const double expected = 0.5 * std::erfc(-z / std::sqrt(2.0));
        EXPECT_NEAR(normal_probability(z), expected, 1e-11) << z;
    }
    EXPECT_EQ(normal_probability(-100.0), 0.0);
    EXPECT_EQ(normal_probability(100.0), 1.0);
}

TEST(MeanAbove, IsTheExcessFarAboveAndNothingFarBelow) {
    EXPECT_NEAR(mean_above(30.0, 5.5, 3.0), 24.5, 1e-12);
    EXPECT_NEAR(mean_above(-30.0, 5.5, 3.0), 0.0, 1e-12);
    // At the base itself a normal scatter lies sigma / sqrt(2 pi) above on average.
    EXPECT_NEAR(mean_above(5.5, 5.5, 3.0), 3.0 / std::sqrt(2.0 * M_PI), 1e-11);
}

}  // namespace
}  // namespace forest::normal_test
