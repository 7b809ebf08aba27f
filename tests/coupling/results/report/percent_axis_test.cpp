#include "coupling/results/report/percent_axis.hpp"

#include <gtest/gtest.h>

namespace coupling::report::percent_axis_test {
namespace {

TEST(PercentAxis, BeginsBelowTheSmallestWhereAllAreHighAndSaysSo) {
    const Axis axis = percent_axis("Rocks kept away, %", 92.3, 99.1);
    EXPECT_DOUBLE_EQ(axis.low, 90.0);
    EXPECT_DOUBLE_EQ(axis.high, 100.0);
    EXPECT_EQ(axis.title, "Rocks kept away, % (axis from 90 on)");
}

TEST(PercentAxis, BeginsAtZeroWhereAnyIsLow) {
    const Axis axis = percent_axis("Rocks kept away, %", 55.0, 99.1);
    EXPECT_DOUBLE_EQ(axis.low, 0.0);
    EXPECT_EQ(axis.title, "Rocks kept away, %");
}

TEST(PercentAxis, HoldsValuesThatAreAllTheSame) {
    for (const double value : {61.0, 96.7, 100.0}) {
        const Axis axis = percent_axis("", value, value);
        EXPECT_LT(axis.low, value);
        EXPECT_GE(axis.high, value);
        EXPECT_LE(axis.high - axis.low, 2.0) << value;
    }
}

}  // namespace
}  // namespace coupling::report::percent_axis_test
