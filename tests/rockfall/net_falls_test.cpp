// Whole falls past nets.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "config/units/constants.hpp"
#include "tests/rockfall/slopes.hpp"

namespace rockfall::net_falls_test {
namespace {

using config::gravity_mps2;
using testing::deterministic_law;
using testing::EventLog;
using testing::logged_fall;
using testing::plane_slope;
using testing::sliding_law;
using testing::start_at;

constexpr Restitution soft{0.30, 0.80};

/// A net across the fall line at an easting.
Net across(const Slope& slope, double x_m, double height_m, double gap_m = 0.0, double capacity_j = 1e12) {
    const Eigen::Vector2d origin_m = slope.terrain.origin_m();
    return {{Eigen::Vector2d{x_m, 10.0} - origin_m, Eigen::Vector2d{x_m, 90.0} - origin_m},
            height_m,
            gap_m,
            capacity_j};
}

std::pair<FallEnd, EventLog> fall_past(const Slope& slope, const FallLaw& law, const RockStart& start,
                                       const NetIndex& nets, std::uint64_t seed = 1) {
    Obstacles obstacles;
    obstacles.nets = &nets;
    return logged_fall(slope, law, start, obstacles, seed);
}

TEST(FallPastANet, HoldsAFlyingRockWithTheEnergyOfItsParabola) {
    const Slope slope = plane_slope(35.0, soft);
    const RockStart start = start_at(slope, 105.0, 50.0, 20.0, {6.0, 0.5, 1.0});
    const NetIndex nets{std::vector{across(slope, 112.0, 60.0)}};
    const auto [end, log] = fall_past(slope, deterministic_law(), start, nets);

    EXPECT_EQ(end.reason, StopReason::net);
    ASSERT_EQ(log.nets.size(), 1U);
    const NetCrossing& crossing = log.nets[0].crossing;
    const double time_s = 7.0 / 6.0;
    const double drop_m = 0.5 * gravity_mps2 * time_s * time_s - 1.0 * time_s;
    const double squared_speed = 36.0 + 0.25 + 1.0 + 2.0 * gravity_mps2 * drop_m;
    EXPECT_NEAR(crossing.translational_j, 0.5 * start.rock.mass_kg * squared_speed, 1e-6);
    EXPECT_NEAR(crossing.energy_j, crossing.translational_j, 1e-9);
    EXPECT_NEAR(crossing.speed_mps, std::sqrt(squared_speed), 1e-9);
    EXPECT_NEAR(crossing.along_m, 40.0 + 0.5 * time_s, 1e-9);
    const double ground_falls_m = 7.0 * std::tan(config::Angle::from_degrees(35.0).in_radians());
    EXPECT_NEAR(crossing.height_m, 20.0 - drop_m + ground_falls_m + start.rock.radius_m, 1e-6);
    EXPECT_EQ(crossing.outcome, NetOutcome::held);
    EXPECT_NEAR(end.position_m.z(), slope.terrain.height_m(end.position_m.x(), end.position_m.y()).value(),
                1e-6);
    EXPECT_NEAR(end.position_m.x() + slope.terrain.origin_m().x(), 112.0 - 1e-3, 1e-5)
        << "a millimetre upslope of the net";
}

TEST(FallPastANet, HoldsARollingRockWithTheEnergyOfConstantAcceleration) {
    const double slope_rad = config::Angle::from_degrees(35.0).in_radians();
    const Slope slope = plane_slope(35.0, soft);
    const Eigen::Vector3d down{std::cos(slope_rad), 0.0, -std::sin(slope_rad)};
    const double way_m = 1.0 / std::cos(slope_rad);
    const double start_mps = 0.5;
    const NetIndex nets{std::vector{across(slope, 106.0, 3.0)}};
    const RockStart start = start_at(slope, 105.0, 50.0, 0.0, start_mps * down);
    for (const FallLaw& law : {deterministic_law(), sliding_law()}) {
        const bool rolls = law.motion.model == motion_model<picus::Model>;
        const double friction = rolls ? law.motion.of<picus::Model>().rolling.friction : 0.6;
        const double acceleration_mps2 =
            (rolls ? 5.0 / 7.0 : 1.0) * gravity_mps2 * (std::sin(slope_rad) - friction * std::cos(slope_rad));
        const double squared_speed = start_mps * start_mps + 2.0 * acceleration_mps2 * way_m;
        const auto [end, log] = fall_past(slope, law, start, nets);
        EXPECT_EQ(end.reason, StopReason::net);
        ASSERT_EQ(log.nets.size(), 1U);
        const NetCrossing& crossing = log.nets[0].crossing;
        EXPECT_NEAR(crossing.speed_mps, std::sqrt(squared_speed), 1e-3);
        EXPECT_NEAR(crossing.height_m, start.rock.radius_m, 1e-9);
        EXPECT_NEAR(crossing.energy_j / crossing.translational_j, rolls ? 1.4 : 1.0, 1e-9);
    }
}

TEST(FallPastANet, GoesOnBitForBitWhereTheRockPassesOverOrBelow) {
    const Slope slope = plane_slope(38.0, soft, 0.01);
    FallLaw picus;
    FallLaw pir3d = sliding_law();
    pir3d.motion.of<pir3d::Model>().uncertainty = pir3d::Uncertainty::by_speed;
    for (const FallLaw& law : {picus, pir3d}) {
        for (std::uint64_t seed = 0; seed < 40; ++seed) {
            const RockStart start = start_at(slope, 105.0, 50.0, seed % 2 == 0 ? 1.5 : 0.0, {3.0, 0.0, 0.0});
            std::vector<Net> passed;
            for (double x_m = 106.0; x_m < 900.0; x_m += 7.0) {
                passed.push_back(across(slope, x_m, 0.3));                // lower than the rock's centre
                passed.push_back(across(slope, x_m + 3.0, 100.0, 99.0));  // higher than any jump
            }
            const auto [free_end, free_log] = logged_fall(slope, law, start, Obstacles{}, seed);
            const auto [end, log] = fall_past(slope, law, start, NetIndex{passed}, seed);
            EXPECT_EQ(end.reason, free_end.reason);
            EXPECT_EQ(end.position_m, free_end.position_m);
            EXPECT_EQ(log.jumps.size(), free_log.jumps.size());
            EXPECT_EQ(log.rolls.size(), free_log.rolls.size());
            for (const EventLog::Crossing& met : log.nets) {
                EXPECT_FALSE(acts(met.crossing.outcome));
            }
        }
    }
}

TEST(FallPastANet, KeepsTheEnergyAboveTheCapacityBehindANetThatBroke) {
    const Slope slope = plane_slope(35.0, soft);
    const RockStart start = start_at(slope, 105.0, 50.0, 20.0, {6.0, 0.5, 1.0});
    const NetIndex nets{std::vector{across(slope, 112.0, 60.0, 0.0, 20e3)}};
    const auto [end, log] = fall_past(slope, deterministic_law(), start, nets);
    ASSERT_EQ(log.nets.size(), 1U);
    EXPECT_EQ(log.nets[0].crossing.outcome, NetOutcome::broke);
    ASSERT_GE(log.jumps.size(), 2U);
    const double behind_j = 0.5 * start.rock.mass_kg * log.jumps[1].flight.velocity_mps.squaredNorm();
    EXPECT_NEAR(behind_j, log.nets[0].crossing.energy_j - 20e3, 1e-6);
    const Eigen::Vector3d before_mps = log.jumps[0].flight.velocity_at(log.jumps[0].until_s);
    EXPECT_NEAR(before_mps.normalized().dot(log.jumps[1].flight.velocity_mps.normalized()), 1.0, 1e-12);
    EXPECT_NE(end.reason, StopReason::net);
}

TEST(FallPastANet, MeetsTwoNetsThatStandOneBehindTheOther) {
    const Slope slope = plane_slope(35.0, soft);
    const RockStart start = start_at(slope, 105.0, 50.0, 20.0, {6.0, 0.5, 1.0});
    const NetIndex nets{std::vector{across(slope, 112.01, 60.0), across(slope, 112.0, 60.0, 0.0, 20e3)}};
    const auto [end, log] = fall_past(slope, deterministic_law(), start, nets);
    ASSERT_EQ(log.nets.size(), 2U);
    EXPECT_EQ(log.nets[0].crossing.net, 1U);
    EXPECT_EQ(log.nets[1].crossing.net, 0U);
    EXPECT_EQ(end.reason, StopReason::net);
}

/// How often the way of a rock changes the side of an easting, looked at in small steps.
std::size_t changes_of_side(const EventLog& log, double x_m) {
    std::size_t changes = 0;
    bool first = true;
    bool beyond = false;
    const auto see = [&](double at_m) {
        changes += !first && (at_m >= x_m) != beyond ? 1U : 0U;
        beyond = at_m >= x_m;
        first = false;
    };
    constexpr int steps = 100;
    for (const EventLog::Jump& jump : log.jumps) {
        for (int i = 0; i <= steps; ++i) {
            see(jump.flight.position_m(jump.until_s * i / steps).x());
        }
    }
    return changes;
}

RC_GTEST_PROP(FallPastANet, CrossesAsOftenAsAFineWalkAlongItsJumpsSays, ()) {
    const Slope slope = plane_slope(40.0, {0.4, 0.9}, 0.0);
    FallLaw law;
    const auto seed = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000));
    const double x_m = 120.0 + *rc::gen::inRange(0, 800);
    const RockStart start = start_at(slope, 105.0, 50.0, 1.5, {4.0, 0.0, 0.0});
    Net wide = across(slope, x_m, 1e-6);
    wide.line_m[0].y() -= 10.0;
    wide.line_m[1].y() += 10.0;
    const auto [end, log] = fall_past(slope, law, start, NetIndex{std::vector{wide}}, seed);
    RC_PRE(log.rolls.empty());
    RC_ASSERT(log.nets.size() == changes_of_side(log, x_m - slope.terrain.origin_m().x()));
}

RC_GTEST_PROP(FallPastANet, NeverGainsEnergyAtANet, ()) {
    const Slope slope = plane_slope(40.0, {0.4, 0.9}, 0.0);
    FallLaw law = *rc::gen::arbitrary<bool>() ? FallLaw{} : sliding_law();
    const auto seed = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000));
    std::vector<Net> weak;
    for (double x_m = 110.0; x_m < 900.0; x_m += 11.0) {
        weak.push_back(across(slope, x_m, 20.0, 0.0, 1e3 * *rc::gen::inRange(1, 40)));
    }
    const RockStart start = start_at(slope, 105.0, 50.0, 1.5, {4.0, 0.0, 0.0});
    const auto [end, log] = fall_past(slope, law, start, NetIndex{weak}, seed);
    const auto energy_j = [&](const Eigen::Vector3d& velocity_mps, double z_m) {
        return start.rock.mass_kg * (0.5 * velocity_mps.squaredNorm() + gravity_mps2 * z_m);
    };
    double before_j = energy_j(start.velocity_mps, start.position_m.z());
    for (const EventLog::Jump& jump : log.jumps) {
        const double now_j = energy_j(jump.flight.velocity_mps, jump.flight.start_m.z());
        if (log.rolls.empty()) {
            RC_ASSERT(now_j <= before_j * (1.0 + 1e-12));
        }
        before_j = now_j;
    }
    for (const EventLog::Crossing& met : log.nets) {
        RC_ASSERT(met.crossing.outcome == NetOutcome::over ||
                  (met.crossing.outcome == NetOutcome::broke) ==
                      (met.crossing.energy_j > weak[met.crossing.net].capacity_j));
    }
}

}  // namespace
}  // namespace rockfall::net_falls_test
