#include "rockfall/tally/target_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace rockfall::target_distance_test {
namespace {

Target line(std::vector<std::vector<Eigen::Vector2d>> parts) {
    Target target;
    target.parts = std::move(parts);
    return with_bounds(target);
}

TEST(DistanceFromATarget, IsThatOfThePerpendicularOrOfAnEnd) {
    const Target road = line({{{0.0, 0.0}, {10.0, 0.0}}});
    const TargetDistance distance{road};
    EXPECT_DOUBLE_EQ(distance.from_m({4.0, 7.0}), 7.0);
    EXPECT_DOUBLE_EQ(distance.from_m({4.0, -7.0}), 7.0);
    EXPECT_DOUBLE_EQ(distance.from_m({13.0, 4.0}), 5.0);
    EXPECT_DOUBLE_EQ(distance.from_m({-3.0, -4.0}), 5.0);
    EXPECT_DOUBLE_EQ(distance.from_m({5.0, 0.0}), 0.0);
}

TEST(DistanceFromATarget, IsNothingInAnAreaAndThatFromItsRimOutside) {
    Target house = line({{{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}, {0.0, 10.0}, {0.0, 0.0}}});
    house.is_area = true;
    const TargetDistance distance{house};
    EXPECT_DOUBLE_EQ(distance.from_m({3.0, 4.0}), 0.0);
    EXPECT_DOUBLE_EQ(distance.from_m({13.0, 14.0}), 5.0);
}

TEST(DistanceFromATarget, OfASinglePointIsThatFromThePoint) {
    const Target point = line({{{1.0, 2.0}}});
    EXPECT_DOUBLE_EQ(TargetDistance{point}.from_m({4.0, 6.0}), 5.0);
}

TEST(DistanceFromATarget, IsTheLeastOverAllPiecesOfLongRoads) {
    std::mt19937 random{7};
    std::uniform_real_distribution<double> place{0.0, 500.0};
    for (int road = 0; road < 20; ++road) {
        std::vector<std::vector<Eigen::Vector2d>> parts(2);
        for (int i = 0; i < 90; ++i) {
            parts[static_cast<std::size_t>(i % 2)].emplace_back(place(random), place(random));
        }
        const Target target = line(parts);
        const TargetDistance distance{target};
        for (int i = 0; i < 50; ++i) {
            const Eigen::Vector2d here{place(random), place(random)};
            // Every point of a fine walk along the lines is at least as far, and some are nearly as near.
            double least = std::numeric_limits<double>::infinity();
            for (const auto& part : parts) {
                for (std::size_t p = 0; p + 1 < part.size(); ++p) {
                    for (int step = 0; step <= 2000; ++step) {
                        least = std::min(least,
                                         (part[p] + step / 2000.0 * (part[p + 1] - part[p]) - here).norm());
                    }
                }
            }
            EXPECT_LE(distance.from_m(here), least + 1e-9);
            EXPECT_NEAR(distance.from_m(here), least, 0.2);
        }
    }
}

}  // namespace
}  // namespace rockfall::target_distance_test
