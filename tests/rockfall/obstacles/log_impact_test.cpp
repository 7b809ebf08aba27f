#include "rockfall/obstacles/log_impact.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "config/random/stream.hpp"
#include "config/units/constants.hpp"
#include "rockfall/motion/picus/ground_contact.hpp"
#include "rockfall/obstacles/stem.hpp"

namespace rockfall::log_impact_test {
namespace {

const Rock rock = Rock::sphere(0.8, 2700.0);

/// A log across the x direction on flat ground.
LogPiece piece_across(double diameter_m, double energy_j, double clearance_m = 0.0) {
    return {.first_m = {0.0, -1.0, clearance_m + 0.5 * diameter_m},
            .along = {0.0, 2.0, 0.0},
            .normal = {0.0, 0.0, 1.0},
            .radius_m = 0.5 * diameter_m,
            .largest_energy_j = energy_j,
            .log = 0};
}

/// The contact of a rock on the ground that comes along +x.
LogHit hit_on_ground(const LogPiece& piece) {
    const double reach_m = rock.radius_m + piece.radius_m;
    const double up = (rock.radius_m - piece.first_m.z()) / reach_m;
    return {0, 0, 0.0, {-std::sqrt(1.0 - up * up), 0.0, up}};
}

LogImpact meet_rolling(const LogPiece& piece, double speed_mps) {
    const double energy_j = 0.7 * rock.mass_kg * speed_mps * speed_mps;
    return meet_log(energy_j, {speed_mps, 0.0, 0.0}, rock, hit_on_ground(piece), piece, {});
}

TEST(MeetLog, StopsARockThatAThickLogCanHold) {
    const LogPiece thick = piece_across(0.6, 50e3);
    EXPECT_EQ(meet_rolling(thick, 8.0).outcome, LogOutcome::stopped);  // 32 kJ
    const LogImpact broken = meet_rolling(thick, 12.0);                // 73 kJ
    EXPECT_EQ(broken.outcome, LogOutcome::broke);
    EXPECT_DOUBLE_EQ(broken.loss_j, 50e3);
    const double before_j = 0.7 * rock.mass_kg * 144.0;
    EXPECT_NEAR(broken.velocity_mps.x(), 12.0 * std::sqrt(1.0 - 50e3 / before_j), 1e-9);
}

TEST(MeetLog, IsClimbedWhereTheTopLiesBelowTheCentre) {
    // 0.4 m is half the diameter of the rock: the limit between low and high.
    const double strong_j = 1e9;
    EXPECT_EQ(meet_rolling(piece_across(0.41, strong_j), 20.0).outcome, LogOutcome::stopped);
    EXPECT_EQ(meet_rolling(piece_across(0.20, 1e3), 20.0).outcome, LogOutcome::broke);
    // A low log of great strength: what the motion into it brings must be paid, and the lift on flat ground
    // is m g times the diameter of the log.
    const LogPiece low = piece_across(0.10, strong_j);
    const double up = (rock.radius_m - 0.05) / (rock.radius_m + 0.05);
    const double straight_share = 1.0 - up * up;
    const double lift_j = rock.mass_kg * config::gravity_mps2 * 0.10;
    // across > lift + straight share * across
    const double least_mps = std::sqrt(lift_j / (1.0 - straight_share) / (0.7 * rock.mass_kg));
    EXPECT_EQ(meet_rolling(low, 0.99 * least_mps).outcome, LogOutcome::stopped);
    const LogImpact climbed = meet_rolling(low, 1.01 * least_mps);
    EXPECT_EQ(climbed.outcome, LogOutcome::climbed);
    EXPECT_NEAR(climbed.loss_j, straight_share * 0.7 * rock.mass_kg * std::pow(1.01 * least_mps, 2), 1e-6);
}

TEST(MeetLog, TakesAtMostItsShareFromARockThatClimbs) {
    const LogPiece low = piece_across(0.2, 10e3);
    const LogImpact climbed =
        meet_rolling(low, 4.5);  // 10.3 kJ, of which three quarters straight into the log
    ASSERT_EQ(climbed.outcome, LogOutcome::climbed);
    EXPECT_DOUBLE_EQ(climbed.loss_j, 0.2 * 10e3);
}

TEST(MeetLog, HoldsAMotionlessRockOnASteepSlopeOnlyIfItIsThickEnough) {
    // The lift is that of the circle around the axis: a rock on a slope of 38 degrees leans on a log of a
    // quarter of its diameter, and rolls over one of a tenth.
    const double b = config::Angle::from_degrees(38.0).in_radians();
    for (const double share : {0.10, 0.25}) {
        const double r = share * rock.radius_m;
        const Eigen::Vector3d normal{std::sin(b), 0.0, std::cos(b)};
        const Eigen::Vector3d down{std::cos(b), 0.0, -std::sin(b)};
        const LogPiece piece{r * normal, {0.0, 1.0, 0.0}, normal, r, 1e9, 0};
        const Eigen::Vector3d to_rock =
            ((rock.radius_m - r) * normal - 2.0 * std::sqrt(rock.radius_m * r) * down) / (rock.radius_m + r);
        EXPECT_EQ(to_rock.x() > 0.0, share < 0.12) << share;  // beyond the top of the log, seen from above
        const LogImpact slow = meet_log(1e-6, 1e-4 * down, rock, {0, 0, 0.0, to_rock}, piece, {});
        EXPECT_EQ(slow.outcome, share < 0.12 ? LogOutcome::climbed : LogOutcome::stopped) << share;
    }
}

TEST(MeetLog, TurnsAFlyingRockThatComesNearlyAlongIt) {
    const LogPiece thick = piece_across(0.6, 1e9);
    const LogHit hit = hit_on_ground(thick);
    const auto meet_at = [&](double across_deg) {
        const double a = config::Angle::from_degrees(across_deg).in_radians();
        return meet_log(10e3, {10.0 * std::sin(a), 10.0 * std::cos(a), 0.0}, rock, hit, thick, {});
    };
    const LogImpact flat = meet_at(20.0);
    ASSERT_EQ(flat.outcome, LogOutcome::turned);
    const double kept = std::cos(config::Angle::from_degrees(20.0).in_radians()) -
                        0.5 * std::sin(config::Angle::from_degrees(20.0).in_radians());
    EXPECT_NEAR(flat.velocity_mps.y(), 10.0 * kept, 1e-9);
    EXPECT_NEAR(flat.velocity_mps.x(), 0.0, 1e-12);
    EXPECT_NEAR(flat.loss_j, 10e3 * (1.0 - kept * kept), 1e-6);
    EXPECT_EQ(meet_at(64.0).outcome, LogOutcome::stopped);  // steeper than 1 / friction: 63.4 degrees
    EXPECT_EQ(meet_at(45.0).outcome, LogOutcome::turned);
}

TEST(MeetLog, IsHeldByTheEndOfALogAndSlidesAroundIt) {
    const LogPiece thick = piece_across(0.6, 50e3);
    const auto meet_end = [&](double aside_deg, double energy_j) {
        // Comes along +y onto the end at y = -1, the contact turned aside by an angle.
        const double a = config::Angle::from_degrees(aside_deg).in_radians();
        return meet_log(energy_j, {0.0, 10.0, 0.0}, rock, {0, 0, 0.0, {std::sin(a), -std::cos(a), 0.0}},
                        thick, {});
    };
    EXPECT_EQ(meet_end(0.0, 40e3).outcome, LogOutcome::stopped);
    EXPECT_EQ(meet_end(0.0, 60e3).outcome, LogOutcome::broke);
    const LogImpact aside = meet_end(60.0, 40e3);
    ASSERT_EQ(aside.outcome, LogOutcome::turned);
    EXPECT_GT(aside.velocity_mps.x(), 0.0);  // to the side on which it came
    EXPECT_GT(aside.velocity_mps.y(), 0.0);
    EXPECT_EQ(aside.velocity_mps.z(), 0.0);
}

RC_GTEST_PROP(MeetLog, NeverGivesEnergy, ()) {
    config::RandomStream stream{{*rc::gen::arbitrary<std::uint32_t>(), 0, 0, 0}, config::Purpose::test};
    const auto random_vector = [&] {
        return Eigen::Vector3d{stream.uniform() - 0.5, stream.uniform() - 0.5, stream.uniform() - 0.5};
    };
    LogPiece piece{random_vector(),         2.0 * random_vector(),   Eigen::Vector3d::UnitZ(),
                   0.05 + stream.uniform(), 50e3 * stream.uniform(), 0};
    const Eigen::Vector3d axis = piece.along.normalized();
    Eigen::Vector3d off = random_vector();
    off = (off - off.dot(axis) * axis).normalized();
    const Eigen::Vector3d velocity = 40.0 * random_vector();
    const double spin = 20.0 * stream.uniform();
    const double energy_j = kinetic_energy_j(rock, velocity.squaredNorm(), spin);
    const LogImpact impact = meet_log(energy_j, velocity, rock, {0, 0, 0.0, off}, piece, {});
    const double after_j =
        kinetic_energy_j(rock, impact.velocity_mps.squaredNorm(), spin * impact.spin_factor);
    RC_ASSERT(impact.loss_j >= 0.0);
    RC_ASSERT(std::abs(energy_j - impact.loss_j - after_j) <= 1e-9 * energy_j);
}

RC_GTEST_PROP(MeetLog, IsTheSameInAMirror, ()) {
    config::RandomStream stream{{*rc::gen::arbitrary<std::uint32_t>(), 1, 0, 0}, config::Purpose::test};
    const auto mirrored = [](const Eigen::Vector3d& v) { return Eigen::Vector3d{v.x(), -v.y(), v.z()}; };
    LogPiece piece{{0.0, 0.0, 0.5}, {stream.uniform() - 0.5, 1.0, 0.1}, {0.0, 0.0, 1.0}, 0.3, 30e3, 0};
    LogPiece mirror = piece;
    mirror.along = mirrored(piece.along);
    const Eigen::Vector3d axis = piece.along.normalized();
    Eigen::Vector3d off{-1.0, 0.0, stream.uniform() - 0.3};
    off = (off - off.dot(axis) * axis).normalized();
    const Eigen::Vector3d velocity{15.0 * stream.uniform(), 10.0 * (stream.uniform() - 0.5),
                                   -5.0 * stream.uniform()};
    const double energy_j = 0.5 * rock.mass_kg * velocity.squaredNorm();
    const LogImpact one = meet_log(energy_j, velocity, rock, {0, 0, 0.0, off}, piece, {});
    const LogImpact other =
        meet_log(energy_j, mirrored(velocity), rock, {0, 0, 0.0, mirrored(off)}, mirror, {});
    RC_ASSERT(one.outcome == other.outcome);
    RC_ASSERT((mirrored(one.velocity_mps) - other.velocity_mps).norm() < 1e-12);
}

}  // namespace
}  // namespace rockfall::log_impact_test
