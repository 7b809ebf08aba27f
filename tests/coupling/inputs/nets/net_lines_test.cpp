#include "coupling/inputs/nets/net_lines.hpp"

#include <gtest/gtest.h>

namespace coupling::net_lines_test {
namespace {

const PlanLine east{{0.0, 0.0}, {10.0, 0.0}};

TEST(SharedLength, IsThatOfTheStretchSideBySide) {
    const PlanLine partly{{4.0, 0.0}, {15.0, 0.0}, {15.0, 5.0}};
    EXPECT_NEAR(shared_length_m(east, partly, 1e-6, 1e-3), 6.0, 1e-9);
    EXPECT_NEAR(shared_length_m(partly, east, 1e-6, 1e-3), 6.0, 1e-9);
    const PlanLine back{{10.0, 0.0}, {0.0, 0.0}};
    EXPECT_NEAR(shared_length_m(east, back, 1e-6, 1e-3), 10.0, 1e-9);
}

TEST(LengthInOnePlace, IsNoneForLinesThatCrossTouchOrFollowEachOther) {
    for (const PlanLine& other : {PlanLine{{10.0, 0.0}, {20.0, 0.0}}, PlanLine{{5.0, -1.0}, {5.0, 1.0}},
                                  PlanLine{{0.0, -2.0}, {10.0, 2.0}}, PlanLine{{5.0, 0.0}, {5.0, 4.0}},
                                  PlanLine{{0.0, 0.02}, {10.0, 0.02}}}) {
        EXPECT_EQ(length_in_one_place_m(east, other), 0.0) << other.front().transpose();
    }
}

TEST(LengthInOnePlace, TakesLinesOfRoundedCoordinatesAsOne) {
    EXPECT_NEAR(length_in_one_place_m(east, {{2.0, 0.004}, {7.0, -0.003}}), 5.0, 1e-3);
    EXPECT_NEAR(length_in_one_place_m(east, {{9.99, 0.0}, {20.0, 0.0}}), 0.01, 1e-9);
}

TEST(LengthInOnePlace, DoesNotDependOnTheNumberOfCorners) {
    PlanLine corners;
    for (int i = 0; i <= 200; ++i) {
        corners.push_back({0.05 * i, i % 2 == 0 ? 0.001 : -0.001});  // as a drawing program rounds them
    }
    EXPECT_NEAR(length_in_one_place_m(east, corners), 10.0, 0.01);
    EXPECT_NEAR(length_in_one_place_m(corners, east), 10.0, 0.01);
    EXPECT_NEAR(length_in_one_place_m(corners, corners), 10.0, 0.01);
}

TEST(MeetsItself, TellsLinesThatCrossOrFoldBackFromThoseThatClose) {
    EXPECT_FALSE(meets_itself(east));
    EXPECT_FALSE(meets_itself({{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 0.0}}));
    EXPECT_TRUE(meets_itself({{0.0, 0.0}, {2.0, 0.0}, {1.0, 0.0}}));
    EXPECT_TRUE(meets_itself({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.0, -1.0}}));
}

}  // namespace
}  // namespace coupling::net_lines_test
