#include "rockfall/motion/picus/ground_contact.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/rockfall/slopes.hpp"

namespace rockfall::picus::ground_contact_test {
namespace {

using testing::deterministic_law;
using testing::EventLog;
using testing::logged_fall;
using testing::plane_slope;
using testing::start_at;

/// Speed after the last of many jumps on an endless plane, speed before the impact and slope length of the
/// jump.
struct FixedPoint {
    double after_mps;
    double before_mps;
    double jump_m;
    double height_m;
};

FixedPoint fixed_point(double slope_deg, Restitution restitution) {
    const Slope slope = plane_slope(slope_deg, restitution, 0.0, 3000.0);
    const auto [end, log] =
        logged_fall(slope, deterministic_law(), start_at(slope, 20.0, 50.0, 1.5, {2.6, 0.0, -1.5}));
    const EventLog::Jump& last = log.jumps[log.jumps.size() - 3];
    const Eigen::Vector3d v = last.flight.velocity_mps;
    const double tangent = std::tan(config::Angle::from_degrees(slope_deg).in_radians());
    const double apex_s = (v.z() + tangent * v.x()) / 9.81;
    return {v.norm(), last.flight.velocity_at(last.until_s).norm(),
            (last.flight.position_m(last.until_s) - last.flight.start_m).norm(),
            last.flight.height_m(apex_s) - (last.flight.start_m.z() - tangent * v.x() * apex_s)};
}

TEST(PicusOnAPlane, SettlesInTheJumpThatTheLawsImply) {
    struct Row {
        Restitution restitution;
        double slope_deg, after, before, jump, height;
    };
    // Fixed points of Eqs. 7-9 on endless planes, to the digits of the reference table.
    for (const Row& row :
         {Row{{0.30, 0.75}, 38.0, 8.59, 12.25, 6.31, 0.48}, Row{{0.30, 0.75}, 45.0, 10.01, 14.93, 8.84, 0.64},
          Row{{0.30, 0.75}, 33.0, 7.68, 10.61, 5.01, 0.39}, Row{{0.30, 0.75}, 30.0, 6.79, 9.28, 4.09, 0.35},
          Row{{0.30, 0.65}, 38.0, 5.44, 8.58, 3.64, 0.37}, Row{{0.30, 0.85}, 38.0, 11.94, 15.99, 9.36, 0.57},
          Row{{0.35, 0.80}, 40.0, 10.61, 14.80, 8.46, 0.57},
          Row{{0.40, 0.90}, 50.0, 17.42, 24.32, 19.14, 1.05}}) {
        const FixedPoint point = fixed_point(row.slope_deg, row.restitution);
        EXPECT_NEAR(point.after_mps, row.after, 0.006) << row.slope_deg;
        EXPECT_NEAR(point.before_mps, row.before, 0.006) << row.slope_deg;
        EXPECT_NEAR(point.jump_m, row.jump, 0.006) << row.slope_deg;
        EXPECT_NEAR(point.height_m, row.height, 0.006) << row.slope_deg;
    }
}

TEST(PicusOnAPlane, GoesOnAboveTheCriticalSlopeAndRollsOutBelow) {
    // Critical slope for r_t = 0.85: atan(sqrt(1/r_t^2 - 1) / 2) = 17.2 degrees.
    const FixedPoint point = fixed_point(20.0, {0.30, 0.85});
    EXPECT_NEAR(point.after_mps, 7.87, 0.006);

    const Slope gentle = plane_slope(15.0, {0.30, 0.85}, 0.0, 3000.0);
    const auto [end, log] =
        logged_fall(gentle, deterministic_law(), start_at(gentle, 20.0, 50.0, 1.5, {5.0, 0.0, 0.0}));
    EXPECT_EQ(end.reason, StopReason::at_rest);
    ASSERT_FALSE(log.rolls.empty());
    EXPECT_GT(log.rolls.back().piece.start_m.x(), log.jumps.back().flight.start_m.x());
}

TEST(PicusVariants, InitialModelKeepsItsCoefficientsAtAnySpeed) {
    // Rammer et al. 2010, section 3.1: v' = r_t v_t - r_n v_n n, constant coefficients. On a plane a jump
    // gives the normal speed back, so it falls by r_n at each impact while the speed along the slope gains 2
    // tan(b) v_n.
    FallLaw law = deterministic_law();
    law.motion.of<picus::Model>().angle = ReboundAngle::geometric;
    law.motion.of<picus::Model>().restitution.damping = false;
    const double b = config::Angle::from_degrees(45.0).in_radians();
    const Slope slope = plane_slope(45.0, {0.60, 0.90}, 0.0, 6000.0);
    const auto [end, log] = logged_fall(slope, law, start_at(slope, 20.0, 50.0, 30.0, {30.0, 0.0, -4.0}));
    ASSERT_GT(log.jumps.size(), 4U);
    const Eigen::Vector3d normal{std::sin(b), 0.0, std::cos(b)};
    for (std::size_t i = 1; i + 1 < 5; ++i) {
        const Eigen::Vector3d before = log.jumps[i].flight.velocity_mps;
        const Eigen::Vector3d after = log.jumps[i + 1].flight.velocity_mps;
        const double normal_mps = before.dot(normal);
        const double along_mps = (before - normal_mps * normal).norm();
        EXPECT_NEAR(after.dot(normal), 0.60 * normal_mps, 1e-9);
        EXPECT_NEAR((after - after.dot(normal) * normal).norm(),
                    0.90 * (along_mps + 2.0 * std::tan(b) * normal_mps), 1e-8);
    }
}

TEST(MeetGround, StopsByChanceOnlyBelowTheProbability) {
    const Rock rock = Rock::sphere(0.95, 2700.0);
    const Law law = deterministic_law().motion.of<picus::Model>();
    ContactDraws draws;
    draws.stop = 0.0149;
    EXPECT_EQ(
        meet_ground({8.0, 0.0, -6.0}, 0.0, Eigen::Vector3d::UnitZ(), {0.3, 0.75}, 0.015, rock, law, draws)
            .onward,
        Onward::caught);
    draws.stop = 0.0151;
    EXPECT_EQ(
        meet_ground({8.0, 0.0, -6.0}, 0.0, Eigen::Vector3d::UnitZ(), {0.3, 0.75}, 0.015, rock, law, draws)
            .onward,
        Onward::flies);
}

TEST(MeetGround, TurnsAVerticalImpactAtACliffFootByTheCoefficients) {
    const Rock rock = Rock::sphere(0.95, 2700.0);
    Law law = deterministic_law().motion.of<picus::Model>();
    const double b = config::Angle::from_degrees(3.0).in_radians();
    const Eigen::Vector3d normal{std::sin(b), 0.0, std::cos(b)};
    law.blend_steep_impacts = true;
    const Contact steep = meet_ground({0.0, 0.0, -20.0}, 0.0, normal, {0.3, 0.75}, 0.0, rock, law, {});
    ASSERT_EQ(steep.onward, Onward::flies);
    const double leaving_deg =
        std::asin(steep.velocity_mps.normalized().dot(normal)) * 180.0 / std::numbers::pi;
    EXPECT_GT(leaving_deg, 60.0);  // r_n v_n stands against almost no r_t v_t
    law.blend_steep_impacts = false;
    const Contact strict = meet_ground({0.0, 0.0, -20.0}, 0.0, normal, {0.3, 0.75}, 0.0, rock, law, {});
    EXPECT_NEAR(std::asin(strict.velocity_mps.normalized().dot(normal)) * 180.0 / std::numbers::pi,
                80.0 * std::pow(strict.velocity_mps.norm(), -0.74), 1e-6);
}

RC_GTEST_PROP(MeetGround, NeverGainsEnergyAndNeverPointsIntoTheGround, ()) {
    const auto number = [](double low, double high) {
        return low + (high - low) * (*rc::gen::inRange(0, 1'000'001)) * 1e-6;
    };
    const double b = number(0.0, 1.3);
    const double azimuth = number(0.0, 6.28);
    const Eigen::Vector3d normal{std::sin(b) * std::cos(azimuth), std::sin(b) * std::sin(azimuth),
                                 std::cos(b)};
    Eigen::Vector3d velocity{number(-40.0, 40.0), number(-40.0, 40.0), number(-40.0, 40.0)};
    RC_PRE(velocity.dot(normal) < -1e-6);
    const Rock rock = Rock::sphere(number(0.1, 4.0), number(2000.0, 3200.0));
    const double spin = number(0.0, 1.0) * velocity.norm() / rock.radius_m;
    Law law;
    law.angle = *rc::gen::element(ReboundAngle::jump_angle_law, ReboundAngle::geometric);
    law.restitution.damping = *rc::gen::arbitrary<bool>();
    const ContactDraws draws{number(-1.0, 1.0), number(-1.0, 1.0), 1.0, number(-2.0, 2.0)};
    const Restitution published{number(0.0, 0.99), number(0.0, 0.99)};
    const Contact contact = meet_ground(velocity, spin, normal, published, 0.0, rock, law, draws);
    const double before = kinetic_energy_j(rock, velocity.squaredNorm(), spin);
    const double after = kinetic_energy_j(rock, contact.velocity_mps.squaredNorm(), contact.spin_radps);
    RC_ASSERT(contact.velocity_mps.allFinite());
    RC_ASSERT(after <= before * (1.0 + 1e-12));
    RC_ASSERT(contact.velocity_mps.norm() <= velocity.norm() * (1.0 + 1e-12));
    RC_ASSERT(contact.velocity_mps.dot(normal) >= -1e-9 * contact.velocity_mps.norm());
}

}  // namespace
}  // namespace rockfall::picus::ground_contact_test
