#include "rockfall/motion/groove.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/rockfall/slopes.hpp"

namespace rockfall {
namespace {

/// A gully that falls by 4 in 5 along x, its walls rising by 1 in 2 to either side.
const Eigen::Vector3d left_wall = Eigen::Vector3d{0.8, -0.5, 1.0}.normalized();
const Eigen::Vector3d right_wall = Eigen::Vector3d{0.8, 0.5, 1.0}.normalized();
const Eigen::Vector3d downhill = Eigen::Vector3d{1.0, 0.0, -0.8}.normalized();

TEST(AlongEdge, KeepsWhatLiesAlongTheFloorOfAGully) {
    // Straight into one wall, and up and down: only the part along the floor is left, with its sign.
    const Eigen::Vector3d across = downhill.cross(Eigen::Vector3d{Eigen::Vector3d::UnitY()});
    for (const double along_mps : {6.0, 0.0, -2.0}) {
        const Eigen::Vector3d velocity_mps =
            along_mps * downhill + 3.0 * Eigen::Vector3d::UnitY() - 1.5 * across;
        for (const Eigen::Vector3d& kept_mps : {along_edge(velocity_mps, left_wall, right_wall),
                                                along_edge(velocity_mps, right_wall, left_wall)}) {
            EXPECT_LT((kept_mps - along_mps * downhill).norm(), 1e-12) << along_mps;
        }
    }
}

TEST(AlongEdge, LiesInBothFacesAndGainsNoSpeed) {
    const Eigen::Vector3d steep = Eigen::Vector3d{0.3, 2.0, 0.4}.normalized();
    const Eigen::Vector3d velocity_mps{4.0, -7.0, -3.0};
    const Eigen::Vector3d kept_mps = along_edge(velocity_mps, left_wall, steep);
    EXPECT_NEAR(kept_mps.dot(left_wall), 0.0, 1e-12);
    EXPECT_NEAR(kept_mps.dot(steep), 0.0, 1e-12);
    EXPECT_GT(kept_mps.dot(velocity_mps), 0.0);
    EXPECT_LT(kept_mps.norm(), velocity_mps.norm());
}

TEST(AlongEdge, IsTheWayInTheFaceWhereThereIsNoEdge) {
    const Eigen::Vector3d velocity_mps{4.0, -7.0, -3.0};
    const Eigen::Vector3d kept_mps = along_edge(velocity_mps, left_wall, left_wall);
    EXPECT_LT((kept_mps - (velocity_mps - velocity_mps.dot(left_wall) * left_wall)).norm(), 1e-12);
}

TEST(StrikesInTurn, AreTwoAtMostUntilTheRockGetsSomewhere) {
    StrikesInTurn strikes;
    for (int twice = 0; twice < 2; ++twice) {
        EXPECT_FALSE(strikes.once_more(0.0));
        EXPECT_FALSE(strikes.once_more(3e-17));
        EXPECT_TRUE(strikes.once_more(0.0));
        EXPECT_TRUE(strikes.once_more(0.0));
        EXPECT_FALSE(strikes.once_more(0.02));
    }
}

TEST(Fall, SlidesOnInAGullyWhoseWallsItStrikesInTurn) {
    // Turned by 20 degrees at most they would strike the walls up to five times in turn in no time.
    const config::GridFrame frame{60, 20, 0.0, 0.0, 5.0, 5.0};
    const Slope gully = testing::slope_over(
        testing::heights_of(frame,
                            [](double x, double y) { return 400.0 - 0.8 * x + 0.5 * std::abs(y - 47.5); }),
        {0.35, 0.85});
    FallLaw law = testing::deterministic_law();
    law.motion.model = MotionModel::classical;
    law.motion.classical.lateral = config::Angle::from_degrees(20.0);
    for (std::uint64_t rock = 0; rock < 200; ++rock) {
        const auto [end, log] = testing::logged_fall(
            gully, law, testing::start_at(gully, 20.0, 60.0, 1.0, {1.0, -1.0, 0.0}, 0.8, rock));
        EXPECT_EQ(end.reason, StopReason::left_terrain) << rock;
        int in_a_row = 0;
        int most_in_a_row = 0;
        for (const testing::EventLog::Jump& jump : log.jumps) {
            in_a_row = jump.until_s < 1e-9 ? in_a_row + 1 : 0;
            most_in_a_row = std::max(most_in_a_row, in_a_row);
        }
        EXPECT_LT(most_in_a_row, 3) << rock;
    }
}

}  // namespace
}  // namespace rockfall
