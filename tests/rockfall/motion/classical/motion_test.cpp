#include "rockfall/motion/classical/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/rockfall/slopes.hpp"

namespace rockfall::classical::motion_test {
namespace {

using rockfall::testing::deterministic_law;
using rockfall::testing::logged_fall;
using rockfall::testing::plane_slope;
using rockfall::testing::start_at;

constexpr double gravity_mps2 = 9.81;
constexpr Restitution ground{0.35, 0.85};

/// The classical model without any chance.
FallLaw plain_law() {
    FallLaw law = deterministic_law();
    law.motion.model = motion_model<classical::Model>;
    law.motion.of<classical::Model>().restitution_deviation = 0.0;
    law.motion.of<classical::Model>().lateral = config::Angle{};
    law.motion.of<classical::Model>().friction = Friction::angle;
    return law;
}

double radians(double degrees) {
    return config::Angle::from_degrees(degrees).in_radians();
}

SurfaceType surface_of(Restitution restitution) {
    SurfaceType surface;
    surface.restitution = restitution;
    return surface;
}

TEST(ClassicalImpact, TakesTheSameShareAtEverySpeed) {
    const Law law = plain_law().motion.of<classical::Model>();
    const Motion motion{law, {}, Rock::sphere(1.0, 2700.0)};
    const Eigen::Vector3d normal = Eigen::Vector3d{0.3, 0.1, 1.0}.normalized();
    for (const double speed_mps : {2.0, 10.0, 40.0}) {
        const Eigen::Vector3d in = speed_mps * Eigen::Vector3d{0.6, 0.2, -0.9}.normalized();
        const Contact contact = motion.touch(in, 0.0, normal, surface_of(ground), {0.5, 0.5, 0.5, 0.5});
        ASSERT_EQ(contact.onward, Onward::flies) << speed_mps;
        const Eigen::Vector3d across = in.dot(normal) * normal;
        EXPECT_NEAR((contact.velocity_mps - (0.85 * (in - across) - 0.35 * across)).norm(), 0.0, 1e-9);
    }
}

TEST(ClassicalImpact, ScattersItsCoefficientsAndItsDirectionAsToldAndGainsNoEnergy) {
    Law law;
    law.restitution_deviation = 0.1;
    law.lateral = config::Angle::from_degrees(20.0);
    Motion motion{law, {.seed = 3}, Rock::sphere(1.0, 2700.0)};
    const Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d in{8.0, 0.0, -6.0};
    constexpr int draws = 4000;
    double sum = 0.0;
    double squares = 0.0;
    double most_rad = 0.0;
    for (int i = 0; i < draws; ++i) {
        const Contact contact = motion.touch(in, 0.0, normal, surface_of(ground), motion.next_draws());
        const double r_n = contact.velocity_mps.z() / 6.0;
        sum += r_n;
        squares += r_n * r_n;
        most_rad =
            std::max(most_rad, std::abs(std::atan2(contact.velocity_mps.y(), contact.velocity_mps.x())));
        EXPECT_LE(contact.velocity_mps.norm(), in.norm());
    }
    const double mean = sum / draws;
    const double deviation = std::sqrt(squares / draws - mean * mean);
    // Four standard errors; a normal distribution cut at three deviations has 0.9866 of its deviation.
    EXPECT_NEAR(mean, 0.35, 4.0 * 0.1 / std::sqrt(draws));
    EXPECT_NEAR(deviation, 0.1 * 0.9866, 4.0 * 0.1 / std::sqrt(2.0 * draws));
    EXPECT_LE(most_rad, radians(20.0) + 1e-12);
    EXPECT_GT(most_rad, radians(20.0) * (1.0 - 10.0 / draws)) << "missed at e^-10";
}

TEST(ClassicalFall, FollowsTheClosedFormFromJumpToJumpOnAnEvenSlope) {
    // Between impacts gravity gives the part along the slope g sin b T, with T = 2 v_n / (g cos b).
    const double b = radians(35.0);
    const Slope slope = plane_slope(35.0, ground);
    const auto [end, log] =
        logged_fall(slope, plain_law(), start_at(slope, 50.0, 50.0, 20.0, {5.0, 0.0, 0.0}));
    ASSERT_GE(log.jumps.size(), 4U);
    const Eigen::Vector3d normal{std::sin(b), 0.0, std::cos(b)};
    const Eigen::Vector3d along{std::cos(b), 0.0, -std::sin(b)};
    const Eigen::Vector3d first = log.jumps[1].flight.velocity_mps;
    double out_mps = first.dot(normal);
    double along_mps = first.dot(along);
    for (std::size_t jump = 2; jump < 4; ++jump) {
        along_mps = 0.85 * (along_mps + 2.0 * out_mps * std::tan(b));
        out_mps *= 0.35;
        EXPECT_NEAR(log.jumps[jump].flight.velocity_mps.dot(normal), out_mps, 1e-6) << jump;
        EXPECT_NEAR(log.jumps[jump].flight.velocity_mps.dot(along), along_mps, 1e-6) << jump;
    }
}

TEST(ClassicalFall, SlidesToRestByItsAngleOfFriction) {
    const double b = radians(20.0);
    const Slope slope = plane_slope(20.0, ground);
    const auto [end, log] =
        logged_fall(slope, plain_law(),
                    start_at(slope, 100.0, 50.0, 0.0, 6.0 * Eigen::Vector3d{std::cos(b), 0.0, -std::sin(b)}));
    EXPECT_EQ(end.reason, StopReason::at_rest);
    const double braking_mps2 = gravity_mps2 * (std::tan(radians(30.0)) * std::cos(b) - std::sin(b));
    const double length_m = 36.0 / (2.0 * braking_mps2);
    EXPECT_NEAR(end.position_m.x() + slope.terrain.origin_m().x(), 100.0 + length_m * std::cos(b), 0.02);
}

TEST(ClassicalFall, TakesItsFrictionFromTheGround) {
    const double b = radians(8.0);
    const Slope slope = plane_slope(8.0, ground);
    FallLaw law = plain_law();
    law.motion.of<classical::Model>().friction = Friction::from_rt;
    const auto [end, log] = logged_fall(
        slope, law, start_at(slope, 100.0, 50.0, 0.0, 3.0 * Eigen::Vector3d{std::cos(b), 0.0, -std::sin(b)}));
    const double braking_mps2 = gravity_mps2 * (0.15 / 0.85 * std::cos(b) - std::sin(b));
    const double length_m = 9.0 / (2.0 * braking_mps2);
    EXPECT_NEAR(end.position_m.x() + slope.terrain.origin_m().x(), 100.0 + length_m * std::cos(b), 0.05);
}

TEST(ClassicalFall, GoesOnDownAnySlopeSteeperThanItsFriction) {
    const double b = radians(32.0);
    const Slope slope = plane_slope(32.0, ground);
    const auto [end, log] =
        logged_fall(slope, plain_law(),
                    start_at(slope, 100.0, 50.0, 0.0, 1.0 * Eigen::Vector3d{std::cos(b), 0.0, -std::sin(b)}));
    EXPECT_EQ(end.reason, StopReason::left_terrain);
}

}  // namespace
}  // namespace rockfall::classical::motion_test
