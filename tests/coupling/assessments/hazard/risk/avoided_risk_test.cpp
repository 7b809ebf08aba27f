#include "coupling/assessments/hazard/risk/avoided_risk.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace coupling::hazard::risk::avoided_risk_test {
namespace {

TEST(AvoidedRisk, IsSetAgainstTheCostOfAllBarriersTogether) {
    AvoidedRisk avoided;
    EXPECT_FALSE(avoided.cost_per_year()) << "of none";
    avoided.barriers = {{"a", "net", {}, 1000.0}, {"b", "dam", {}, 250.0}};
    EXPECT_DOUBLE_EQ(avoided.cost_per_year().value(), 1250.0);
    avoided.barriers.push_back({"c", "wall", {}, std::nullopt});
    EXPECT_FALSE(avoided.cost_per_year()) << "one is not known";
}

TEST(AvoidedRisk, TurnsTheIntervalOverWhereItIsDividedBy) {
    const Estimate money{5000.0, 3000.0, 9000.0};
    const Ratio benefit = benefit_by_cost(money, 1000.0);
    EXPECT_DOUBLE_EQ(benefit.value, 5.0);
    EXPECT_DOUBLE_EQ(benefit.low, 3.0);
    EXPECT_DOUBLE_EQ(benefit.high, 9.0);
    const Ratio each = cost_of_each({0.002, 0.001, 0.004}, 1000.0);
    EXPECT_DOUBLE_EQ(each.value, 500'000.0);
    EXPECT_DOUBLE_EQ(each.low, 250'000.0);
    EXPECT_DOUBLE_EQ(each.high, 1'000'000.0);
    const Ratio open = cost_of_each({0.002, -0.001, 0.004}, 1000.0);
    EXPECT_TRUE(std::isinf(open.high));
    EXPECT_TRUE(std::isinf(cost_of_each({0.0, 0.0, 0.0}, 1000.0).value));
}

}  // namespace
}  // namespace coupling::hazard::risk::avoided_risk_test
