#include "rockfall/tally/target.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "config/random/stream.hpp"
#include "rockfall/tally/target_distance.hpp"

namespace rockfall::target_test {
namespace {

using Eigen::Vector2d;

Target house_of_ten_metres() {
    Target target;
    target.is_area = true;
    target.parts = {{{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}, {0.0, 10.0}, {0.0, 0.0}}};
    return with_bounds(target);
}

TEST(FirstTouch, IsWhereTheSideMeetsAWall) {
    const Target house = house_of_ten_metres();
    // Straight at a wall: half a metre before it.
    EXPECT_DOUBLE_EQ(first_touch(house, {-10.0, 5.0}, {0.0, 5.0}, 0.5).value(), 0.95);
    // Along a wall, a hand's breadth nearer or further than the radius. It meets the circle around the corner
    // where 0.3^2 + 0.4^2 = 0.5^2.
    EXPECT_DOUBLE_EQ(first_touch(house, {-10.0, -0.4}, {20.0, -0.4}, 0.5).value(), (10.0 - 0.3) / 30.0);
    EXPECT_FALSE(first_touch(house, {-10.0, -0.6}, {20.0, -0.6}, 0.5).has_value());
    // Towards a corner along the diagonal, and past it.
    const double to_corner = std::sqrt(2.0) * 10.0;
    EXPECT_NEAR(first_touch(house, {-10.0, -10.0}, {0.0, 0.0}, 0.5).value(), 1.0 - 0.5 / to_corner, 1e-12);
    EXPECT_FALSE(first_touch(house, {-1.0, 0.2}, {0.2, -1.0}, 0.2).has_value());
    // Already there, also without a way; away from it still touches at the start.
    EXPECT_EQ(first_touch(house, {-0.4, 5.0}, {-3.0, 5.0}, 0.5), 0.0);
    EXPECT_EQ(first_touch(house, {-0.4, 5.0}, {-0.4, 5.0}, 0.5), 0.0);
    EXPECT_FALSE(first_touch(house, {-0.6, 5.0}, {-0.6, 5.0}, 0.5).has_value());
    // Inside, far from the walls.
    EXPECT_FALSE(first_touch(house, {4.0, 4.0}, {6.0, 6.0}, 0.5).has_value());
}

TEST(FirstTouch, IsTheFirstPlaceWithinTheRadius) {
    config::RandomStream draw{{3, 0, 0, 5}, config::Purpose::sampling};
    const auto place = [&] { return Vector2d{30.0 * draw.uniform() - 10.0, 30.0 * draw.uniform() - 10.0}; };
    int touches = 0;
    for (int i = 0; i < 3000; ++i) {
        Target road;
        road.parts = {{place(), place(), place()}};
        road = with_bounds(road);
        const TargetDistance distance{road};
        const Vector2d from = place();
        const Vector2d to = place();
        const double radius_m = 0.1 + 2.0 * draw.uniform();
        const auto touch = first_touch(road, from, to, radius_m);
        double sampled = 2.0;
        for (int k = 0; k <= 400 && sampled > 1.0; ++k) {
            const Vector2d at = from + k / 400.0 * (to - from);
            sampled = distance.from_m(at) <= radius_m ? k / 400.0 : sampled;
        }
        if (!touch) {
            EXPECT_GT(sampled, 1.0);
            continue;
        }
        ++touches;
        EXPECT_LE(*touch, sampled);
        EXPECT_LE(distance.from_m(from + *touch * (to - from)), radius_m + 1e-9);
        // Up to there it is further away.
        for (const double share : {0.25, 0.5, 0.9, 0.999}) {
            EXPECT_GT(distance.from_m(from + share * *touch * (to - from)),
                      *touch > 0.0 ? radius_m - 1e-9 : -1.0);
        }
    }
    EXPECT_GT(touches, 500);
}

}  // namespace
}  // namespace rockfall::target_test
