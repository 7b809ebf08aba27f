// Whole falls along profiles.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/rockfall/slopes.hpp"
#include "tests/rockfall/terrain/profiles.hpp"

namespace rockfall::profile_falls_test {
namespace {

using testing::deterministic_law;
using testing::even_profile;
using testing::EventLog;
using testing::ground;
using testing::height_on;
using testing::logged_fall;
using testing::random_profile;
using testing::start_at;

/// Chance at full strength, but nothing that turns a rock sideways.
FallLaw lively_law() {
    FallLaw law;
    law.motion.of<picus::Model>().lateral = {config::Angle{}, config::Angle{}};
    return law;
}

/// A rock on the middle line of a strip, down the fall line.
RockStart on_profile(const Slope& slope, double distance_m, double height_m, std::uint64_t id = 0) {
    RockStart start = start_at(slope, distance_m, 0.0, height_m, {3.0, 0.0, -1.7}, 0.95, id);
    if (start.rolling) {
        const double rise = slope.terrain.plane_of(start.triangle).gradient.x();
        start.velocity_mps = Eigen::Vector3d{1.0, 0.0, rise}.normalized();
    }
    return start;
}

/// Largest gain of total mechanical energy per mass from one event of a fall to the next, flights and rolls.
struct EnergyWatch {
    Rock rock;
    double last = std::numeric_limits<double>::infinity();
    double largest_gain = 0.0;
    double fastest_rolling_mps = 0.0;

    void pass(double height_m, double squared_speed, double spin, double end_height_m,
              double end_squared_speed, double end_spin) {
        const auto energy = [&](double z_m, double squared, double spin_radps) {
            return kinetic_energy_j(rock, squared, spin_radps) / rock.mass_kg + 9.81 * z_m;
        };
        const double begin = energy(height_m, squared_speed, spin);
        const double end = energy(end_height_m, end_squared_speed, end_spin);
        largest_gain = std::max({largest_gain, begin - last, end - begin});
        last = end;
    }
    void flew(const Rock&, const Flight& flight, double until_s, std::span<const Stretch>, double spin) {
        pass(flight.start_m.z(), flight.squared_speed_at(0.0), spin, flight.height_m(until_s),
             flight.squared_speed_at(until_s), spin);
    }
    void rolled(const Rock&, const RollingPiece& piece, std::uint32_t) {
        const Eigen::Vector3d end_mps = piece.velocity_at(piece.duration_s);
        pass(piece.start_m.z(), piece.velocity_mps.squaredNorm(), piece.velocity_mps.norm() / rock.radius_m,
             piece.position_m(piece.duration_s).z(), end_mps.squaredNorm(), end_mps.norm() / rock.radius_m);
        fastest_rolling_mps = std::max({fastest_rolling_mps, piece.velocity_mps.norm(), end_mps.norm()});
    }
    void impacted(const Eigen::Vector3d&, int) {}
    void met_stem(const Eigen::Vector3d&, const StemHit&, const TreeImpact&, double) {}
    void met_log(const Eigen::Vector3d&, const LogHit&, const LogImpact&, double) {}
    void crossed_net(const Eigen::Vector3d&, const NetCrossing&) {}
};

/// Largest change of slope from one piece of a profile to the next [m/m].
double largest_bend(const std::vector<ProfilePoint>& profile) {
    double largest = 0.0;
    for (std::size_t i = 2; i < profile.size(); ++i) {
        const auto slope_before = [&](std::size_t k) {
            return (profile[k].height_m - profile[k - 1].height_m) /
                   (profile[k].distance_m - profile[k - 1].distance_m);
        };
        largest = std::max(largest, std::abs(slope_before(i) - slope_before(i - 1)));
    }
    return largest;
}

RC_GTEST_PROP(FallAlongAProfile, NeverGainsEnergyWhileItRolls, ()) {
    const auto seed = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000));
    const auto profile = random_profile(seed);
    const Slope slope = strip_slope(profile, {ground({0.3, 0.8}), ground({0.35, 0.9}, 0.01)});
    for (const double height_m : {0.0, 1.5}) {
        const RockStart start = on_profile(slope, -10.0, height_m, seed);
        EnergyWatch watch{start.rock};
        FallScratch scratch;
        fall(slope, {}, lively_law(), {1, 0, 0, seed}, start, scratch, watch);
        // A piece shorter than 5 ms runs over its edge on its own plane and is then put on the face beyond,
        // which may lie higher by the way run over times the bend.
        const double put_up_m = shortest_rolling_piece_s * watch.fastest_rolling_mps * largest_bend(profile);
        RC_ASSERT(watch.largest_gain < 1e-6 + config::gravity_mps2 * put_up_m);
    }
}

RC_GTEST_PROP(FallAlongAProfile, StaysOnTheMiddleLineToTheBit, ()) {
    const auto seed = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000));
    const auto profile = random_profile(seed);
    const Slope slope = strip_slope(profile, {ground({0.3, 0.8}), ground({0.35, 0.9}, 0.01)});
    for (const double height_m : {0.0, 1.5}) {
        const auto [end, log] = logged_fall(slope, lively_law(), on_profile(slope, -10.0, height_m, seed));
        RC_ASSERT(end.reason != StopReason::gave_up);
        RC_ASSERT(end.position_m.y() == 0.0);
        for (const EventLog::Jump& jump : log.jumps) {
            RC_ASSERT(jump.flight.start_m.y() == 0.0);
            RC_ASSERT(jump.flight.velocity_mps.y() == 0.0);
        }
        for (const EventLog::Roll& roll : log.rolls) {
            RC_ASSERT(roll.piece.velocity_mps.y() == 0.0);
            RC_ASSERT(roll.piece.acceleration_mps2.y() == 0.0);
        }
    }
}

RC_GTEST_PROP(FallAlongAProfile, NeverGainsEnergyAndStaysOnTheSurface, ()) {
    const auto seed = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000));
    const auto profile = random_profile(seed);
    const Slope slope = strip_slope(profile, {ground({0.3, 0.8}), ground({0.35, 0.9}, 0.01)});
    const RockStart start = on_profile(slope, -10.0, 1.5, seed);
    const auto [end, log] = logged_fall(slope, lively_law(), start);
    const auto energy_per_mass = [&](const Eigen::Vector3d& velocity, double spin, double height_m) {
        return kinetic_energy_j(start.rock, velocity.squaredNorm(), spin) / start.rock.mass_kg +
               9.81 * height_m;
    };
    double last = energy_per_mass(start.velocity_mps, 0.0, start.position_m.z());
    for (const EventLog::Jump& jump : log.jumps) {
        const double begin =
            energy_per_mass(jump.flight.velocity_mps, jump.spin_radps, jump.flight.start_m.z());
        RC_ASSERT(begin <= last + 1e-6);
        last = begin;
        for (int i = 1; i < 20; ++i) {
            const Eigen::Vector3d p = jump.flight.position_m(jump.until_s * i / 20.0);
            RC_ASSERT(p.z() >= height_on(profile, p.x()) - 1e-5);
        }
    }
    RC_ASSERT(std::abs(end.position_m.z() - height_on(profile, end.position_m.x())) < 1e-5 ||
              end.reason == StopReason::left_terrain);
}

TEST(FallAlongAProfile, ReachesTheFixedPointOfAnEvenSlope) {
    // Endless plane of 38 deg, r_n 0.30, r_t 0.75: v 8.59 m/s after and 12.25 m/s before an impact, jumps of
    // 6.31 m along the slope.
    const Slope slope = strip_slope(even_profile(38.0, 3000.0), {ground({0.30, 0.75})});
    const auto [end, log] = logged_fall(slope, deterministic_law(), on_profile(slope, 5.0, 1.5));
    EXPECT_EQ(end.reason, StopReason::left_terrain);
    ASSERT_GT(log.jumps.size(), 100U);
    const EventLog::Jump& jump = log.jumps[log.jumps.size() - 2];
    EXPECT_NEAR(jump.flight.velocity_mps.norm(), 8.59, 0.005);
    EXPECT_NEAR(jump.flight.velocity_at(jump.until_s).norm(), 12.25, 0.005);
    EXPECT_NEAR((jump.flight.position_m(jump.until_s) - jump.flight.start_m).norm(), 6.31, 0.005);
}

TEST(FallAlongAProfile, IsThatOverAPlaneWithoutDeviation) {
    const double length_m = 600.0;
    for (const double slope_deg : {33.0, 40.0}) {
        const Slope strip = strip_slope(even_profile(slope_deg, length_m), {ground({0.30, 0.80}, 0.01)});
        const Slope plane = testing::plane_slope(slope_deg, {0.30, 0.80}, 0.01, 1000.0);
        const double from_m = plane.terrain.origin_m().x();
        int compared = 0;
        for (std::uint64_t rock = 0; rock < 50; ++rock) {
            RockStart on_strip = on_profile(strip, 20.0, 1.5, rock);
            RockStart on_plane = start_at(plane, 20.0, 50.0, 1.5, on_strip.velocity_mps, 0.95, rock);
            const auto [strip_end, strip_log] = logged_fall(strip, lively_law(), on_strip);
            const auto [plane_end, plane_log] = logged_fall(plane, lively_law(), on_plane);
            // Pieces of rolling end at edges, of which the plane has others.
            if (!strip_log.rolls.empty() || !plane_log.rolls.empty()) {
                continue;
            }
            ++compared;
            const std::size_t jumps = std::min(strip_log.jumps.size(), plane_log.jumps.size());
            for (std::size_t i = 0; i + 1 < jumps; ++i) {
                EXPECT_NEAR(strip_log.jumps[i].flight.start_m.x(),
                            plane_log.jumps[i].flight.start_m.x() + from_m, 1e-6)
                    << rock << ' ' << i;
                EXPECT_NEAR(strip_log.jumps[i].spin_radps, plane_log.jumps[i].spin_radps, 1e-6);
            }
            if (strip_end.reason != StopReason::left_terrain) {
                EXPECT_EQ(plane_end.reason, strip_end.reason) << rock;
                EXPECT_NEAR(strip_end.position_m.x(), plane_end.position_m.x() + from_m, 1e-6) << rock;
            }
        }
        EXPECT_GT(compared, 20) << slope_deg;
    }
}

TEST(FallAlongAProfile, LandsOnACornerAsBesideIt) {
    // Two flights onto the edge between two pieces of one plane, and a hair beside it.
    const std::vector<ProfilePoint> profile{{0.0, 100.0, 0}, {16.0, 92.0, 0}, {64.0, 68.0, 0}};
    const Slope slope = strip_slope(profile, {ground({0.30, 0.80})});
    for (const double beside_m : {-1e-9, 0.0, 1e-9}) {
        // Falls onto x = 16: straight down from there and along a parabola that ends there.
        const Flight down{{16.0 + beside_m, 0.0, 96.0}, Eigen::Vector3d::Zero()};
        const double time_s = 2.0;
        const double sink_mps = 0.5 * 9.81 * time_s;
        const Flight along{{16.0 + beside_m - 4.0 * time_s, 0.0, 96.0}, {4.0, 0.0, sink_mps - 4.0 / time_s}};
        for (const Flight& flight : {down, along}) {
            std::vector<Stretch> stretches;
            const std::uint32_t under = slope.terrain.locate(flight.start_m.x(), 0.0).value();
            const Landing landing = fly(slope.terrain, flight, under, stretches);
            EXPECT_EQ(landing.end, FlightEnd::ground);
            EXPECT_NEAR(flight.position_m(landing.time_s).x(), 16.0, 1e-6);
            EXPECT_NEAR(stretches.back().ground_end_m, 92.0, 1e-6);
            EXPECT_EQ(landing.plane.gradient, Eigen::Vector2d(-0.5, 0.0));
        }
    }
}

TEST(FallAlongAProfile, RollsOverEveryDiagonalWithoutNoticing) {
    // Even ground of 20 deg with friction below its tangent: v^2 grows evenly, whatever the corners.
    const Slope slope = strip_slope(even_profile(20.0, 400.0), {ground({0.30, 0.80})});
    FallLaw law = deterministic_law();
    law.motion.of<picus::Model>().rolling.friction = 0.3;
    law.motion.of<picus::Model>().rolling.launch_factor = 1e9;
    const RockStart start = on_profile(slope, 3.0, 0.0);
    const auto [end, log] = logged_fall(slope, law, start);
    EXPECT_EQ(end.reason, StopReason::left_terrain);
    EXPECT_NEAR(end.position_m.x(), 400.0, 1e-6);
    const double b = config::Angle::from_degrees(20.0).in_radians();
    const double acceleration = 5.0 / 7.0 * 9.81 * (std::sin(b) - 0.3 * std::cos(b));
    for (const EventLog::Roll& roll : log.rolls) {
        const double way_m = (roll.piece.start_m - start.position_m).norm();
        EXPECT_NEAR(roll.piece.velocity_mps.squaredNorm(), 1.0 + 2.0 * acceleration * way_m, 1e-6);
    }
    EXPECT_GT(log.rolls.size(), 90U);
}

TEST(FallAlongAProfile, LeavesOverEitherEnd) {
    const std::vector<ProfilePoint> ridge{{0.0, 0.0, 0}, {40.0, 30.0, 0}, {80.0, 0.0, 0}};
    const Slope slope = strip_slope(ridge, {ground({0.30, 0.85})});
    for (const double height_m : {0.0, 2.0}) {
        for (const double x_m : {30.0, 50.0}) {
            const double way = x_m < 40.0 ? -1.0 : 1.0;
            RockStart start = start_at(slope, x_m, 0.0, height_m, way * Eigen::Vector3d{2.0, 0.0, 0.0});
            start.velocity_mps.z() = -1.5;  // down the fall line
            const auto [end, log] = logged_fall(slope, deterministic_law(), start);
            EXPECT_EQ(end.reason, StopReason::left_terrain);
            EXPECT_NEAR(end.position_m.x(), x_m < 40.0 ? 0.0 : 80.0, 1e-6);
        }
    }
}

TEST(FallAlongAProfile, JumpsOffACliffAndLandsAtItsFoot) {
    // Rolls at 3 m/s over the edge of a cliff of 20 m in 1 cm: thrown x = v_x t with t from the drop.
    const double slope = -0.5;
    const std::vector<ProfilePoint> profile{
        {0.0, 110.0, 0}, {20.0, 100.0, 0}, {20.01, 80.0, 0}, {80.0, 50.005, 0}};
    const Slope strip = strip_slope(profile, {ground({0.30, 0.80})});
    FallLaw law = deterministic_law();
    law.motion.of<picus::Model>().rolling.launch_factor = 1e9;
    for (const double ahead_m : {15.0, 1.0, 0.02, 0.008, 0.001, 1e-6}) {
        RockStart start =
            start_at(strip, 20.0 - ahead_m, 0.0, 0.0, 3.0 * Eigen::Vector3d{1.0, 0.0, slope}.normalized());
        const auto [end, log] = logged_fall(strip, law, start);
        ASSERT_FALSE(log.jumps.empty()) << ahead_m;
        const Flight& flight = log.jumps.front().flight;
        const double until_s = log.jumps.front().until_s;
        EXPECT_NEAR(flight.start_m.x(), 20.0, 0.011) << ahead_m;
        EXPECT_NEAR(flight.start_m.z(), 100.0, 0.02) << ahead_m;
        // Meets the slope below: z = 80 - 0.5 (x - 20.01).
        EXPECT_NEAR(flight.height_m(until_s), 80.0 - 0.5 * (flight.position_m(until_s).x() - 20.01), 1e-3);
        EXPECT_GT(flight.position_m(until_s).x(), 24.0) << ahead_m;
    }
}

TEST(FallAlongAProfile, RestsBeforeACounterSlope) {
    const std::vector<ProfilePoint> dam{{0.0, 60.0, 0}, {80.0, 0.0, 0}, {120.0, 0.0, 0}, {122.0, 40.0, 0}};
    const Slope slope = strip_slope(dam, {ground({0.30, 0.75})});
    for (std::uint64_t rock = 0; rock < 100; ++rock) {
        const auto [end, log] = logged_fall(slope, lively_law(), on_profile(slope, 2.0, 1.5, rock));
        EXPECT_EQ(end.reason, StopReason::at_rest) << rock;
        EXPECT_GE(end.position_m.x(), 70.0) << rock;
        EXPECT_LE(end.position_m.x(), 122.0) << rock;
    }
}

}  // namespace
}  // namespace rockfall::profile_falls_test
