#include "forest/production/light_response.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace forest::light_response_test {
namespace {

TEST(LightResponse, LiesBetweenTheTwoCurvesAndRisesWithLight) {
    EXPECT_DOUBLE_EQ(light_response(1.0, 0.05), 0.0);
    EXPECT_NEAR(light_response(1.0, 1.0), 1.0 - std::exp(-4.64 * 0.95), 1e-9);
    EXPECT_NEAR(light_response(9.0, 0.5), 2.24 * (1.0 - std::exp(-1.136 * 0.42)), 1e-9);
    for (double light = 0.0; light < 1.0; light += 0.01) {
        EXPECT_LE(light_response(4.6, light), light_response(4.6, light + 0.01));
    }
}

TEST(LightResponse, LetsTolerantSpeciesGrowWhereOthersDoNot) {
    EXPECT_GT(light_response(1.0, 0.1), 3.0 * light_response(9.0, 0.1));
}

}  // namespace
}  // namespace forest::light_response_test
