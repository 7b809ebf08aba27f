#include "coupling/assessments/nets/moving/area_around.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace coupling::moving::area_around_test {
namespace {

const PlanLine line{{0.0, 0.0}, {30.0, 0.0}, {40.0, 10.0}};

TEST(AreaAround, HoldsAllThatIsNoFartherThanItsWidth) {
    const AreaAround area{line, 5.0};
    for (const Eigen::Vector2d& corner : line) {
        for (int i = 0; i < 360; ++i) {
            const Eigen::Vector2d way{std::cos(0.01745 * i), std::sin(0.01745 * i)};
            const Eigen::Vector2d place = corner + 4.98 * way;
            EXPECT_TRUE(area.touches(place, place));
        }
    }
    EXPECT_FALSE(area.touches({0.0, -5.2}, {30.0, -5.2}));
    EXPECT_TRUE(area.touches({0.0, -4.9}, {30.0, -5.2}));
}

TEST(AreaAround, IsTouchedByWaysThatPassThroughAndNotByThoseBeside) {
    const AreaAround area{line, 5.0};
    EXPECT_TRUE(area.touches({15.0, -100.0}, {15.0, 100.0}));
    EXPECT_TRUE(area.touches({-100.0, 0.0}, {100.0, 0.0}));
    EXPECT_FALSE(area.touches({-100.0, -100.0}, {-6.0, 100.0}));
    // The boxes of both overlap.
    EXPECT_FALSE(area.touches({36.0, -6.0}, {46.0, 3.0}));
}

TEST(AreaAround, GoesRoundCounterClockwise) {
    const AreaAround area{line, 5.0};
    const PlanLine& corners = area.corners_m();
    double area2 = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector2d& a = corners[i];
        const Eigen::Vector2d& b = corners[(i + 1) % corners.size()];
        area2 += a.x() * b.y() - b.x() * a.y();
    }
    EXPECT_GT(area2, 0.0);
}

TEST(AreaAround, MayTouchTrianglesThatReachInOrGoRoundIt) {
    const AreaAround area{line, 5.0};
    const std::array<Eigen::Vector2d, 3> around{{{-500.0, -500.0}, {500.0, -500.0}, {0.0, 500.0}}};
    const std::array<Eigen::Vector2d, 3> beyond{{{36.0, -6.0}, {60.0, -6.0}, {60.0, 8.0}}};
    EXPECT_TRUE(area.may_touch(around));
    EXPECT_FALSE(area.may_touch(beyond));
}

}  // namespace
}  // namespace coupling::moving::area_around_test
