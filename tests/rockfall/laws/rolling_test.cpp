#include "rockfall/laws/rolling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "rockfall/terrain/face.hpp"
#include "tests/rockfall/slopes.hpp"

namespace rockfall::rolling_test {
namespace {

using testing::deterministic_law;
using testing::logged_fall;
using testing::plane_slope;
using testing::start_at;

constexpr double mu = 0.5;
constexpr double never_launches = std::numeric_limits<double>::infinity();

Eigen::Vector3d down_the_fall_line(double slope_deg, double speed_mps) {
    const double b = config::Angle::from_degrees(slope_deg).in_radians();
    return speed_mps * Eigen::Vector3d{std::cos(b), 0.0, -std::sin(b)};
}

/// A law under which a rolling rock never lifts off.
FallLaw only_rolling() {
    FallLaw law = deterministic_law();
    law.motion.of<picus::Model>().rolling.launch_factor = 1e9;
    return law;
}

TEST(Rolling, StopsWhereTheClosedFormSays) {
    // Azzoni et al. 1995: v0 = 5 m/s on 20 degrees with friction 0.5 gives 13.96 m along the slope.
    const Slope slope = plane_slope(20.0, {0.3, 0.75});
    const RockStart start = start_at(slope, 100.0, 50.0, 0.0, down_the_fall_line(20.0, 5.0));
    const auto [end, log] = logged_fall(slope, only_rolling(), start);
    EXPECT_EQ(end.reason, StopReason::at_rest);
    EXPECT_NEAR((end.position_m - start.position_m).norm(), 13.96, 0.005);
}

TEST(Rolling, AcceleratesOnSteepGroundAsAzzoniSays) {
    // 5/7 g (sin b - mu cos b) = 1.553 m/s2 at 38 degrees.
    const double b = config::Angle::from_degrees(38.0).in_radians();
    const Eigen::Vector3d normal{std::sin(b), 0.0, std::cos(b)};
    const Eigen::Vector3d direction{std::cos(b), 0.0, -std::sin(b)};
    EXPECT_NEAR(rolling_acceleration(normal, direction, mu).dot(direction), 1.553, 0.0005);
    EXPECT_NEAR(rolling_acceleration(normal, direction, mu).dot(normal), 0.0, 1e-12);
}

TEST(Rolling, FollowsTheHodographAcrossTheFallLine) {
    // v(psi) = C tan(psi/2)^kappa / sin(psi) with psi from the fall line and kappa = mu / tan b.
    constexpr double slope_deg = 35.0;
    const Slope slope = plane_slope(slope_deg, {0.3, 0.75}, 0.0, 2000.0, 400.0);
    const double b = config::Angle::from_degrees(slope_deg).in_radians();
    const Eigen::Vector3d along{std::cos(b), 0.0, -std::sin(b)};
    const Eigen::Vector3d across = Eigen::Vector3d::UnitY();
    const RockStart start = start_at(slope, 100.0, 50.0, 0.0, 6.0 * (0.2 * along + std::sqrt(0.96) * across));
    const auto [end, log] = logged_fall(slope, only_rolling(), start);
    const double kappa = mu / std::tan(b);
    const auto constant = [&](const Eigen::Vector3d& v) {
        const double psi = std::atan2(std::abs(v.dot(across)), v.dot(along));
        return v.norm() * std::sin(psi) / std::pow(std::tan(0.5 * psi), kappa);
    };
    const double expected = constant(start.velocity_mps);
    ASSERT_GT(log.rolls.size(), 20U);
    for (const auto& roll : log.rolls) {
        const Eigen::Vector3d v = roll.piece.velocity_at(roll.piece.duration_s);
        if (std::atan2(std::abs(v.dot(across)), v.dot(along)) < 0.1) {
            break;  // the constant loses its digits where the path has turned downhill
        }
        EXPECT_NEAR(constant(v) / expected, 1.0, 2e-3);
    }
}

TEST(Rolling, LosesExactlyTheWorkOfFriction) {
    constexpr double slope_deg = 30.0;
    const Slope slope = plane_slope(slope_deg, {0.3, 0.75});
    const RockStart start = start_at(slope, 100.0, 50.0, 0.0, down_the_fall_line(slope_deg, 3.0));
    const auto [end, log] = logged_fall(slope, only_rolling(), start);
    const double normal_z = std::cos(config::Angle::from_degrees(slope_deg).in_radians());
    for (const auto& roll : log.rolls) {
        const Eigen::Vector3d from = roll.piece.start_m;
        const Eigen::Vector3d to = roll.piece.position_m(roll.piece.duration_s);
        const double gained = 0.7 * (roll.piece.velocity_at(roll.piece.duration_s).squaredNorm() -
                                     roll.piece.velocity_mps.squaredNorm());
        const double fallen = 9.81 * (from.z() - to.z());
        EXPECT_NEAR(gained, fallen - mu * 9.81 * normal_z * (to - from).norm(), 1e-6);
    }
}

TEST(Rolling, RestsOnFlatGroundWithoutSpeed) {
    const Slope slope = plane_slope(10.0, {0.3, 0.75});
    const RockStart start = start_at(slope, 100.0, 50.0, 0.0, Eigen::Vector3d::Zero());
    const Face face{slope.terrain.plane_of(start.triangle)};
    const RollingPiece piece =
        roll(slope.terrain, start.triangle, face, start.position_m, start.velocity_mps, mu, never_launches);
    EXPECT_EQ(piece.end, RollingEnd::standstill);
    EXPECT_EQ(piece.duration_s, 0.0);
}

TEST(Rolling, StartsByItselfOnlyAboveTheFrictionAngle) {
    // atan(0.5) = 26.57 degrees
    for (const auto& [slope_deg, moves] : {std::pair{26.0, false}, std::pair{27.2, true}}) {
        const Slope slope = plane_slope(slope_deg, {0.3, 0.75});
        const auto [end, log] =
            logged_fall(slope, only_rolling(), start_at(slope, 100.0, 50.0, 0.0, Eigen::Vector3d::Zero()));
        EXPECT_EQ(end.reason == StopReason::left_terrain, moves) << slope_deg << " degrees";
    }
}

TEST(RollingPiece, TellsWhenAShareOfItsWayIsCovered) {
    // From rest s = a t^2 / 2: a quarter of the way takes half of the time, and none of it no time; a run
    // that begins against a tree asks for that.
    const RollingPiece from_rest{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                                 {2.0, 0.0, 0.0},         3.0,
                                 RollingEnd::edge,        no_triangle};
    EXPECT_EQ(from_rest.time_along_s(0.0), 0.0);
    EXPECT_DOUBLE_EQ(from_rest.time_along_s(0.25), 1.5);
    EXPECT_DOUBLE_EQ(from_rest.time_along_s(1.0), 3.0);
    // Slowing from 4 m/s to rest in 2 s: three quarters of the way take half of the time.
    const RollingPiece to_rest{Eigen::Vector3d::Zero(), {4.0, 0.0, 0.0}, {-2.0, 0.0, 0.0}, 2.0,
                               RollingEnd::standstill,  no_triangle};
    EXPECT_EQ(to_rest.time_along_s(0.0), 0.0);
    EXPECT_DOUBLE_EQ(to_rest.time_along_s(0.75), 1.0);
    EXPECT_DOUBLE_EQ(to_rest.time_along_s(1.0), 2.0);
}

}  // namespace
}  // namespace rockfall::rolling_test
