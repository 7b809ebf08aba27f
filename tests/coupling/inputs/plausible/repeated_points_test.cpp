#include "coupling/inputs/plausible/repeated_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <tuple>
#include <vector>

namespace coupling::plausible::repeated_points_test {
namespace {

/// A slope of 40 points; the first `repeated` stand there a second time, so much higher.
std::vector<Eigen::Vector3d> survey(int repeated, double higher_m) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 40; ++i) {
        points.emplace_back(1000.0 + 10.0 * (i % 8), 2000.0 + 10.0 * (i / 8), 400.0 - 6.0 * (i % 8));
    }
    for (int i = 0; i < repeated; ++i) {
        points.push_back(points[static_cast<std::size_t>(i)] + Eigen::Vector3d{0.0, 0.0, higher_m});
    }
    return points;
}

TEST(RepeatedPoints, AreThoseWithAnotherHeightInAnyOrderAndDirection) {
    std::mt19937 random{3};
    for (const auto& [repeated, higher_m, expected] :
         {std::tuple{0, 0.0, 0U}, {7, 0.0, 0U}, {7, 0.3, 0U}, {7, 18.0, 7U}, {7, -18.0, 7U}}) {
        std::vector<Eigen::Vector3d> points = survey(repeated, higher_m);
        for (int turn = 0; turn < 4; ++turn) {
            std::shuffle(points.begin(), points.end(), random);
            EXPECT_EQ(points_with_two_heights(points), expected) << repeated << " by " << higher_m;
            for (Eigen::Vector3d& point : points) {
                point.head<2>() = Eigen::Vector2d{-point.y(), point.x()};
            }
        }
    }
}

}  // namespace
}  // namespace coupling::plausible::repeated_points_test
