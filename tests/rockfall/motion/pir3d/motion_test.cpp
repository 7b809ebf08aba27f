#include "rockfall/motion/pir3d/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/rockfall/motion/pir3d/bent_slopes.hpp"

namespace rockfall::pir3d::motion_test {
namespace {

using rockfall::pir3d::testing::edge_x_m;
using rockfall::pir3d::testing::transitions;
using rockfall::pir3d::testing::Way;
using rockfall::pir3d::testing::way_of;
using rockfall::testing::EventLog;
using rockfall::testing::logged_fall;
using rockfall::testing::plane_slope;
using rockfall::testing::sliding_law;
using rockfall::testing::start_at;
using rockfall::testing::test_soil;

/// The last roll that ends at the edge between the two faces.
const RollingPiece& before_edge(const Way& way) {
    for (const EventLog::Roll& roll : way.log.rolls) {
        const double x_m =
            roll.piece.position_m(roll.piece.duration_s).x() + way.slope.terrain.origin_m().x();
        if (std::abs(x_m - edge_x_m) < 1e-3) {
            return roll.piece;
        }
    }
    throw std::logic_error{"never slid to the edge"};
}

/// Speed of the first roll that begins at the edge.
double speed_beyond_edge(const Way& way) {
    for (const EventLog::Roll& roll : way.log.rolls) {
        if (roll.piece.start_m.x() + way.slope.terrain.origin_m().x() > edge_x_m - 1e-3) {
            return roll.piece.velocity_mps.norm();
        }
    }
    throw std::logic_error{"does not slide beyond the edge"};
}

TEST(Transition, A_AnImpactThatLeavesSteeplyIsAFlight) {
    const Way way = way_of(transitions()[0]);
    ASSERT_GE(way.log.jumps.size(), 2U);
    EXPECT_GE(way.log.impacts.size(), 1U);
    // R_T along the face and R_N across it.
    const Eigen::Vector3d in = way.log.jumps[0].flight.velocity_at(way.log.jumps[0].until_s);
    const Eigen::Vector3d out = way.log.jumps[1].flight.velocity_mps;
    const Eigen::Vector3d normal = way.slope.terrain.plane_of(way.start.triangle).normal();
    EXPECT_NEAR(out.dot(normal), -0.35 * in.dot(normal), 1e-9);
    EXPECT_NEAR((out - out.dot(normal) * normal).norm(), 0.85 * (in - in.dot(normal) * normal).norm(), 1e-9);
}

TEST(Transition, B_AnImpactThatLeavesFlatlyIsASlide) {
    const Way way = way_of(transitions()[1]);
    EXPECT_EQ(way.log.jumps.size(), 1U);
    EXPECT_EQ(way.log.impacts.size(), 1U);
    ASSERT_FALSE(way.log.rolls.empty());
    EXPECT_TRUE(way.log.rolls[0].piece.slides);
    const Eigen::Vector3d in = way.log.jumps[0].flight.velocity_at(way.log.jumps[0].until_s);
    const Eigen::Vector3d normal = way.slope.terrain.plane_of(way.start.triangle).normal();
    EXPECT_NEAR(way.log.rolls[0].piece.velocity_mps.norm(), 0.85 * (in - in.dot(normal) * normal).norm(),
                1e-9);
}

TEST(Transition, C_AConvexEdgeAboveTheThresholdIsAFlightWithoutLoss) {
    const Way way = way_of(transitions()[2]);
    ASSERT_GE(way.log.jumps.size(), 1U);
    const RollingPiece& last = before_edge(way);
    const Flight& flight = way.log.jumps[0].flight;
    EXPECT_NEAR(flight.start_m.x() + way.slope.terrain.origin_m().x(), edge_x_m, 1e-5);
    EXPECT_NEAR((flight.velocity_mps - last.velocity_at(last.duration_s)).norm(), 0.0, 1e-6);
}

TEST(Transition, D_AConvexEdgeBelowTheThresholdIsSlidOver) {
    const Way way = way_of(transitions()[3]);
    EXPECT_TRUE(way.log.jumps.empty());
    EXPECT_TRUE(way.log.impacts.empty());
    const RollingPiece& last = before_edge(way);
    EXPECT_NEAR(speed_beyond_edge(way), last.velocity_at(last.duration_s).norm(), 1e-6);
}

TEST(Transition, E_AConcaveEdgeAboveTheThresholdIsAnImpactWithLossAndAFlight) {
    const Way way = way_of(transitions()[4]);
    ASSERT_GE(way.log.impacts.size(), 1U);
    ASSERT_GE(way.log.jumps.size(), 1U);
    const RollingPiece& last = before_edge(way);
    // It meets the second face, 25 degrees flatter, at that angle.
    const double bend = config::Angle::from_degrees(25.0).in_radians();
    const double before_mps = last.velocity_at(last.duration_s).norm();
    EXPECT_NEAR(way.log.jumps[0].flight.velocity_mps.norm(),
                before_mps * std::hypot(0.85 * std::cos(bend), 0.35 * std::sin(bend)), 1e-6);
}

TEST(Transition, F_AConcaveEdgeBelowTheThresholdIsSlidOver) {
    const Way way = way_of(transitions()[5]);
    EXPECT_TRUE(way.log.jumps.empty());
    EXPECT_TRUE(way.log.impacts.empty());
    const RollingPiece& last = before_edge(way);
    EXPECT_NEAR(speed_beyond_edge(way), last.velocity_at(last.duration_s).norm(), 1e-6);
}

TEST(SlidingRock, MeetsTreesWithItsEnergyOfTranslation) {
    const Slope slope = plane_slope(35.0, {0.35, 0.85});
    const StemIndex stems{std::vector<Stem>{{105.0, 50.0, 60.0, 25.0, 1.0}}, slope.terrain, 0.5, false};
    const double b = config::Angle::from_degrees(35.0).in_radians();
    const RockStart start =
        start_at(slope, 100.0, 50.0, 0.0, 3.0 * Eigen::Vector3d{std::cos(b), 0.0, -std::sin(b)});
    const auto [end, log] = logged_fall(slope, sliding_law(), start, &stems);
    ASSERT_EQ(log.hits.size(), 1U);
    EXPECT_EQ(end.reason, StopReason::tree);
    const double way_m = (5.0 - 0.475 - 0.30) / std::cos(b);
    const double squared_speed = 9.0 + 2.0 * 9.81 * (std::sin(b) - 0.6 * std::cos(b)) * way_m;
    EXPECT_NEAR(log.hits[0].energy_j, 0.5 * start.rock.mass_kg * squared_speed, 1e-3 * log.hits[0].energy_j);
}

TEST(SlidingRock, KeepsOneFrictionOnEachStretch) {
    // Drawn once where a stretch begins: from step to step the acceleration stays, from rock to rock it
    // differs.
    const Slope slope = plane_slope(40.0, {0.35, 0.85});
    const double b = config::Angle::from_degrees(40.0).in_radians();
    FallLaw law = sliding_law();
    law.motion.of<pir3d::Model>().uncertainty = Uncertainty::constant;
    std::vector<double> frictions;
    for (std::uint64_t rock = 0; rock < 500; ++rock) {
        const auto [end, log] =
            logged_fall(slope, law,
                        start_at(slope, 100.0, 50.0, 0.0,
                                 3.0 * Eigen::Vector3d{std::cos(b), 0.0, -std::sin(b)}, 0.6, rock));
        ASSERT_GT(log.rolls.size(), 3U);
        const double first = log.rolls[0].piece.acceleration_mps2.norm();
        EXPECT_NEAR(log.rolls[2].piece.acceleration_mps2.norm(), first, 1e-6);
        frictions.push_back((9.81 * std::sin(b) - first) / (9.81 * std::cos(b)));
    }
    const auto [least, largest] = std::minmax_element(frictions.begin(), frictions.end());
    // Uniform on 0.6 (1 +- 0.15); of 500 draws the extremes miss the ends by a 1/50 of the width at e^-10.
    EXPECT_GE(*least, 0.6 * 0.85 - 1e-6);
    EXPECT_LE(*largest, 0.6 * 1.15 + 1e-6);
    EXPECT_LT(*least, 0.6 * (0.85 + 0.3 / 50.0));
    EXPECT_GT(*largest, 0.6 * (1.15 - 0.3 / 50.0));
}

TEST(SlidingRock, HasTheFrictionOfTheSpeedWithWhichAStretchBegins) {
    Law law;
    law.uncertainty = Uncertainty::by_speed;
    SurfaceType type;
    type.soil = rockfall::testing::test_soil();
    const auto friction_of = [&](std::uint64_t rock, double speed_mps) {
        Motion motion{law, {1, 0, 0, rock}, Rock::sphere(1.0, 2700.0)};
        motion.begin_rolling(speed_mps);
        return motion.groove_law(type).friction;
    };
    // The same draw, in widths that go from 15 % at rest to 10 % from 10 m/s on.
    for (std::uint64_t rock = 0; rock < 20; ++rock) {
        const double at_rest = friction_of(rock, 0.0) - 0.6;
        EXPECT_NEAR(friction_of(rock, 5.0) - 0.6, at_rest * 12.5 / 15.0, 1e-12);
        EXPECT_NEAR(friction_of(rock, 20.0) - 0.6, at_rest * 10.0 / 15.0, 1e-12);
    }
}

TEST(SlidingRock, StaysInThePlaneOfAProfile) {
    const Slope slope = plane_slope(40.0, {0.35, 0.85});
    FallLaw law = sliding_law();
    law.motion.of<pir3d::Model>().uncertainty = Uncertainty::by_speed;
    law.motion.of<pir3d::Model>().turns_sideways = false;
    for (std::uint64_t rock = 0; rock < 50; ++rock) {
        const auto [end, log] =
            logged_fall(slope, law, start_at(slope, 100.0, 50.0, 1.5, {3.0, 0.0, -1.5}, 0.6, rock));
        EXPECT_NEAR(end.position_m.y() + slope.terrain.origin_m().y(), 50.0, 1e-6);
    }
}

TEST(SlidingRock, JumpsStraightUpOnLevelGround) {
    // A jump that leads nowhere is one as long as it is higher than the least hop: h R_N^2, h R_N^4 ...
    const Slope flat = plane_slope(0.0, {0.5, 0.9});
    for (const MotionModel model : {motion_model<pir3d::Model>, motion_model<classical::Model>}) {
        FallLaw law = sliding_law();
        law.motion.model = model;
        law.motion.of<pir3d::Model>().least_hop = law.motion.of<classical::Model>().least_hop = 0.1;
        law.motion.of<classical::Model>().restitution_deviation = 0.0;
        law.motion.of<classical::Model>().lateral = config::Angle{};
        Slope ground = flat;
        ground.types[0].soil = rockfall::testing::test_soil(0.6, {0.5, 0.9});
        const auto [end, log] =
            logged_fall(ground, law, start_at(ground, 100.0, 50.0, 10.0, {0.0, 0.0, 0.0}, 1.0));
        // Its centre falls by 10 m or 9.5 m; heights of 2.5, 0.625, 0.156 m pass the least hop of 0.05 m.
        EXPECT_EQ(log.impacts.size(), 4U);
        EXPECT_EQ(end.reason, StopReason::at_rest);
    }
}

TEST(SlidingRock, ComesToRestOnFlatGround) {
    const Slope flat = plane_slope(0.0, {0.50, 0.90});
    FallLaw law = sliding_law();
    law.motion.of<pir3d::Model>().uncertainty = Uncertainty::by_speed;
    for (std::uint64_t rock = 0; rock < 50; ++rock) {
        const auto [end, log] =
            logged_fall(flat, law, start_at(flat, 100.0, 50.0, 10.0, {5.0, 0.0, 0.0}, 0.95, rock));
        EXPECT_EQ(end.reason, StopReason::at_rest);
        EXPECT_LT(end.ground_impacts, 60U);
    }
}

}  // namespace
}  // namespace rockfall::pir3d::motion_test
