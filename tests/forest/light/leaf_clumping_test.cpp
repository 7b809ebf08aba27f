#include "forest/light/leaf_clumping.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace forest::leaf_clumping_test {
namespace {

TEST(MeanLightWithin, IsTheMeanOfTheLawOfBeer) {
    EXPECT_DOUBLE_EQ(mean_light_within(0.0), 1.0);
    for (const double depth : {1e-5, 0.3, 2.0, 9.0}) {
        constexpr int slices = 100'000;
        double sum = 0.0;
        for (int i = 0; i < slices; ++i) {
            sum += std::exp(-depth * (i + 0.5) / slices) / slices;
        }
        EXPECT_NEAR(mean_light_within(depth), sum, 1e-8) << depth;
    }
}

TEST(CrownDepth, SpreadsTheLeavesOverOneAndAHalfTimesWhatTheCrownCovers) {
    EXPECT_NEAR(crown_depth(0.5, 60.0, 2.0), 0.5 * 60.0 / (1.5 * std::numbers::pi * 4.0), 1e-12);
}

TEST(AbsorptionWhenClumped, IsWholeWhereCrownsFillTheColumn) {
    EXPECT_DOUBLE_EQ(absorption_when_clumped(2.0, 2.0), 1.0);
    EXPECT_DOUBLE_EQ(absorption_when_clumped(1.0, 3.0), 1.0) << "never more than the column has";
}

TEST(AbsorptionWhenClumped, OfATreeAloneIsThatOfItsCrown) {
    constexpr double hardly_any = 1e-6;
    for (const double depth : {0.5, 2.0, 4.0}) {
        EXPECT_NEAR(absorption_when_clumped(depth, hardly_any), mean_light_within(1.5 * depth), 1e-5)
            << depth;
    }
}

TEST(AbsorptionWhenClumped, FallsWithTheCrownAndRisesWithItsNeighbours) {
    double before = 1.0;
    for (double depth = 0.6; depth < 6.0; depth += 0.2) {
        const double share = absorption_when_clumped(depth, 0.5);
        EXPECT_LT(share, before);
        EXPECT_LT(share, absorption_when_clumped(depth, 0.55));
        before = share;
    }
}

}  // namespace
}  // namespace forest::leaf_clumping_test
