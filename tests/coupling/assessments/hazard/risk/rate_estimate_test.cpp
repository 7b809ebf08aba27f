#include "coupling/assessments/hazard/risk/rate_estimate.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>

#include "config/random/stream.hpp"

namespace coupling::hazard::risk::rate_estimate_test {
namespace {

RateSum equal_weights(int rocks, double weight) {
    RateSum sum;
    sum.could_add(weight);
    for (int i = 0; i < rocks; ++i) {
        sum.add(weight);
    }
    return sum;
}

TEST(RateEstimate, OfEqualWeightsIsTheExactOneOfPoissonCounts) {
    // Tables of the exact interval (Garwood 1936): of 0 events 0 to 3.69, of 10 events 4.80 to 18.39.
    const Estimate none = estimate(equal_weights(0, 2.0));
    EXPECT_EQ(none.value, 0.0);
    EXPECT_EQ(none.low, 0.0);
    EXPECT_NEAR(none.high, 2.0 * 3.689, 0.001);
    const Estimate ten = estimate(equal_weights(10, 0.5));
    EXPECT_NEAR(ten.value, 5.0, 1e-12);
    EXPECT_NEAR(ten.low, 0.5 * 4.795, 0.001);
    EXPECT_NEAR(ten.high, 0.5 * 18.391, 0.001);
}

TEST(RateEstimate, IsNothingWhereNothingCanCome) {
    const Estimate nothing = estimate(RateSum{});
    EXPECT_EQ(nothing.value, 0.0);
    EXPECT_EQ(nothing.low, 0.0);
    EXPECT_EQ(nothing.high, 0.0);
}

/// Small and large weights mixed: the interval holds the true rate in 95 % of the experiments or more.
TEST(RateEstimate, CoversTheTrueRate) {
    constexpr int experiments = 1500;
    constexpr int rocks = 400;
    constexpr std::array<double, 3> weights{0.1, 1.0, 5.0};
    constexpr std::array<double, 3> chances{0.03, 0.02, 0.004};
    const double truth =
        rocks * (weights[0] * chances[0] + weights[1] * chances[1] + weights[2] * chances[2]);
    config::RandomStream stream{{.seed = 2}, config::Purpose::sampling};
    int covered = 0;
    for (int e = 0; e < experiments; ++e) {
        RateSum sum;
        sum.could_add(weights[2]);
        for (int i = 0; i < rocks; ++i) {
            double u = stream.uniform();
            for (std::size_t k = 0; k < weights.size(); ++k) {
                if (u < chances[k]) {
                    sum.add(weights[k]);
                    break;
                }
                u -= chances[k];
            }
        }
        const Estimate found = estimate(sum);
        covered += found.low <= truth && truth <= found.high ? 1 : 0;
    }
    // Four standard errors of a share of 0.95 below it.
    EXPECT_GT(covered, experiments * (0.95 - 4.0 * std::sqrt(0.95 * 0.05 / experiments)));
    EXPECT_LT(covered, experiments);
}

RC_GTEST_PROP(RateEstimate, HoldsTheValueAndScalesWithTheWeights, ()) {
    const auto weights = *rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 1000));
    RateSum sum;
    RateSum thrice;
    for (const int weight : weights) {
        sum.add(weight);
        thrice.add(3.0 * weight);
    }
    const Estimate one = estimate(sum);
    const Estimate three = estimate(thrice);
    RC_ASSERT(one.low <= one.value);
    RC_ASSERT(one.value <= one.high);
    RC_ASSERT(std::abs(three.low - 3.0 * one.low) <= 1e-9 * (1.0 + three.low));
    RC_ASSERT(std::abs(three.high - 3.0 * one.high) <= 1e-9 * (1.0 + three.high));
}

RC_GTEST_PROP(RateDifference, TurnsItsSignWithItsSides, ()) {
    const RateSum a = equal_weights(*rc::gen::inRange(0, 60), 0.25);
    const RateSum b = equal_weights(*rc::gen::inRange(0, 60), 0.25);
    const Estimate ab = difference(a, b);
    const Estimate ba = difference(b, a);
    RC_ASSERT(ab.value == -ba.value);
    RC_ASSERT(std::abs(ab.low + ba.high) < 1e-12);
    RC_ASSERT(std::abs(ab.high + ba.low) < 1e-12);
    RC_ASSERT(ab.low <= ab.value && ab.value <= ab.high);
    if (a.sum == b.sum) {
        RC_ASSERT(ab.low < 0.0 && ab.high > 0.0);
    }
}

}  // namespace
}  // namespace coupling::hazard::risk::rate_estimate_test
