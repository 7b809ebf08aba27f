#include "coupling/assessments/nets/figures/net_quantiles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace coupling::net_quantiles_test {
namespace {

TEST(QuantileOf, IsTheSmallestValueThatTheShareDoesNotExceed) {
    std::vector<double> values;
    for (int i = 1; i <= 100; ++i) {
        values.push_back(i);
    }
    const QuantileEstimate p95 = quantile_of(values, 0.95);
    EXPECT_EQ(p95.value, 95.0);
    EXPECT_LT(p95.interval.low, 95.0);
    EXPECT_GT(p95.interval.high, 95.0);
    EXPECT_TRUE(std::isinf(quantile_of(std::vector{1.0, 2.0}, 0.95).interval.high));
}

TEST(RocksToTell, AreOneThatMayPass) {
    EXPECT_EQ(rocks_to_tell(0.5), 2U);
    EXPECT_EQ(rocks_to_tell(0.9), 10U);
    EXPECT_EQ(rocks_to_tell(0.95), 20U);
    EXPECT_EQ(rocks_to_tell(0.97), 34U);
    EXPECT_EQ(rocks_to_tell(0.99), 100U);
    EXPECT_EQ(rocks_to_tell(0.9999), 10000U);
}

}  // namespace
}  // namespace coupling::net_quantiles_test
