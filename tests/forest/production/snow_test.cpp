#include "forest/production/snow.hpp"

#include <gtest/gtest.h>

namespace forest::snow_test {
namespace {

TEST(SnowShare, IsHalfAtTheDividingTemperature) {
    EXPECT_NEAR(snow_share(0.5), 0.5, 1e-12);
    EXPECT_GT(snow_share(-15.0), 0.9999);
    EXPECT_LT(snow_share(20.0), 1e-5);
}

TEST(MeltCapacity, IsThatOfDegreeDaysInSummerAndOfWarmDaysInWinter) {
    EXPECT_NEAR(melt_capacity_mm(20.0, 31.0), 0.7 * 31.0 * 20.0, 1e-3);
    EXPECT_GT(melt_capacity_mm(-2.0, 31.0), 0.0);
    EXPECT_NEAR(melt_capacity_mm(-30.0, 31.0), 0.0, 1e-9);
}

}  // namespace
}  // namespace forest::snow_test
