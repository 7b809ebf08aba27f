#include "rockfall/obstacles/log_index.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "rockfall/obstacles/stem.hpp"
#include "rockfall/obstacles/tree_energy.hpp"
#include "tests/rockfall/slopes.hpp"

namespace rockfall::log_index_test {
namespace {

using testing::plane_slope;

constexpr std::uint64_t seed = 21;
constexpr double radius_m = 0.4;

Log log_between(double x1_m, double y1_m, double x2_m, double y2_m, double diameter_cm = 40.0) {
    return {.x1_m = x1_m,
            .y1_m = y1_m,
            .x2_m = x2_m,
            .y2_m = y2_m,
            .diameter1_cm = diameter_cm,
            .diameter2_cm = diameter_cm,
            .supported = true};
}

const Slope& flat() {
    static const Slope slope = plane_slope(0.0, {0.3, 0.75}, 0.0, 1000.0, 1000.0);
    return slope;
}

/// A place in absolute coordinates, so high above the ground, in those of the terrain.
Eigen::Vector3d place(const Slope& slope, double x_m, double y_m, double height_m) {
    const Eigen::Vector2d p = Eigen::Vector2d{x_m, y_m} - slope.terrain.origin_m();
    return {p.x(), p.y(), slope.terrain.height_m(p.x(), p.y()).value() + height_m};
}

/// The first log met by a rock that rolls eastward for 20 m.
std::optional<LogHit> met_rolling(const LogIndex& logs, double y_m = 500.0) {
    return logs.first_hit_rolling(place(flat(), 490.0, y_m, 0.0), {10.0, 0.0, 0.0}, 2.0, radius_m, {}, {});
}

/// How far in plan a rock on flat ground is from the axis when it touches a log.
double plan_reach_m(double rock_radius_m, double log_radius_m, double clearance_m = 0.0) {
    const double reach_m = rock_radius_m + log_radius_m;
    const double rise_m = clearance_m + log_radius_m - rock_radius_m;
    return std::sqrt(reach_m * reach_m - rise_m * rise_m);
}

TEST(LogIndex, IsMetWhereTheSphereTouchesTheCylinder) {
    const LogIndex logs{std::vector<Log>{log_between(500.0, 490.0, 500.0, 510.0)}, flat().terrain, radius_m,
                        0.5};
    const auto hit = met_rolling(logs);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(10.0 * hit->time_s, 10.0 - plan_reach_m(radius_m, 0.2), 2e-3);
    EXPECT_EQ(hit->log, 0U);
    EXPECT_LT(hit->towards_rock.x(), 0.0);
    EXPECT_NEAR(hit->towards_rock.z(), 0.2 / 0.6, 5e-3);
    EXPECT_FALSE(met_rolling(logs, 510.0 + plan_reach_m(radius_m, 0.2) + 0.01));
    EXPECT_TRUE(met_rolling(logs, 510.0 + plan_reach_m(radius_m, 0.2) - 0.01));
}

TEST(LogIndex, LetsRocksPassBelowThatAreSmallerThanTheClearance) {
    for (const double slope_deg : {0.0, 20.0, 38.0}) {
        const Slope slope = plane_slope(slope_deg, {0.3, 0.75}, 0.0, 1000.0, 1000.0);
        const double tangent = std::tan(config::Angle::from_degrees(slope_deg).in_radians());
        for (const double clearance_m : {0.75, 0.85}) {
            Log log = log_between(500.0, 490.0, 500.0, 510.0);
            log.clearance_m = clearance_m;
            const LogIndex logs{std::vector<Log>{log}, slope.terrain, radius_m, 0.5};
            const bool met = logs.first_hit_rolling(place(slope, 490.0, 500.0, 0.0),
                                                    {10.0, 0.0, -10.0 * tangent}, 2.0, radius_m, {}, {})
                                 .has_value();
            EXPECT_EQ(met, clearance_m < 2.0 * radius_m) << slope_deg << " degrees, " << clearance_m << " m";
        }
    }
}

TEST(LogIndex, IsFlownOver) {
    Log log = log_between(500.0, 490.0, 500.0, 510.0);
    log.clearance_m = 0.3;  // top 0.7 m above the ground
    const LogIndex logs{std::vector<Log>{log}, flat().terrain, radius_m, 0.5};
    // At 20 m/s a flight falls by 1.2 m on the 10 m to the log, by 1.3 m until its far side.
    for (const double height_m : {1.80, 2.10}) {
        const Flight flight{place(flat(), 490.0, 500.0, height_m), {20.0, 0.0, 0.0}};
        EXPECT_EQ(logs.first_hit(flight, 1.0, radius_m, {}, {}).has_value(), height_m < 1.9) << height_m;
    }
}

TEST(LogIndex, AlongThePathIsHardlyMet) {
    // Seen along the path a log is as wide as its reach, across the path as long as it is.
    const auto hits_of = [](const Log& log) {
        const LogIndex logs{std::vector<Log>{log}, flat().terrain, radius_m, 0.5};
        int hits = 0;
        for (int i = 0; i < 400; ++i) {
            hits += met_rolling(logs, 490.0 + 0.05 * i) ? 1 : 0;
        }
        return 0.05 * hits;
    };
    EXPECT_NEAR(hits_of(log_between(495.0, 500.0, 505.0, 500.0)), 2.0 * plan_reach_m(radius_m, 0.2), 0.06);
    EXPECT_NEAR(hits_of(log_between(500.0, 495.0, 500.0, 505.0)), 10.0 + 2.0 * plan_reach_m(radius_m, 0.2),
                0.06);
}

TEST(LogIndex, MeetsTheMeanFreePathOfLines) {
    // A straight path meets a log of length L whose axis crosses it at the angle a where its centre comes
    // nearer to the axis than the reach r: the log shows it the width L |sin a| + 2 r. The mean of |sin a|
    // over all directions is 2 / pi, so n logs per m2 are met every 1 / (n (2 L / pi + 2 r)) m.
    constexpr double side_m = 980.0;
    constexpr double length_m = 8.0;
    constexpr std::size_t count = 3000;
    std::vector<Log> field;
    for (std::size_t i = 0; i < count; ++i) {
        config::RandomStream stream{{seed, 0, 0, i}, config::Purpose::test};
        const double x_m = 10.0 + side_m * stream.uniform();
        const double y_m = 10.0 + side_m * stream.uniform();
        const double angle = std::numbers::pi * stream.uniform();
        const double dx = 0.5 * length_m * std::cos(angle);
        const double dy = 0.5 * length_m * std::sin(angle);
        field.push_back(log_between(x_m - dx, y_m - dy, x_m + dx, y_m + dy, 30.0));
    }
    const LogIndex logs{field, flat().terrain, radius_m, 0.5};
    double travelled_m = 0.0;
    int hits = 0;
    for (std::uint64_t i = 0; i < 20'000; ++i) {
        config::RandomStream stream{{seed, 1, 0, i}, config::Purpose::test};
        const Eigen::Vector3d start_m =
            place(flat(), 250.0 + 500.0 * stream.uniform(), 250.0 + 500.0 * stream.uniform(), 0.0);
        const double angle = 2.0 * std::numbers::pi * stream.uniform();
        constexpr double until_s = 20.0;
        const auto hit = logs.first_hit_rolling(
            start_m, {10.0 * std::cos(angle), 10.0 * std::sin(angle), 0.0}, until_s, radius_m, {}, {});
        if (hit && hit->time_s == 0.0) {
            continue;  // begins on a log
        }
        travelled_m += 10.0 * (hit ? hit->time_s : until_s);
        hits += hit ? 1 : 0;
    }
    const double per_m2 = count / (side_m * side_m);
    const double expected_m =
        1.0 / (per_m2 * (2.0 * length_m / std::numbers::pi + 2.0 * plan_reach_m(radius_m, 0.15)));
    EXPECT_NEAR(travelled_m / hits, expected_m, 0.03 * expected_m);
}

/// So near a rock touches a log.
constexpr double touching_m = 1e-3;

/// How a rock lies to a piece of a log.
struct Lying {
    double gap_m;
    bool moves_towards;
};

RC_GTEST_PROP(LogIndex, FindsWhatALookInSmallStepsFinds, ()) {
    static const std::vector<Log> field = [] {
        std::vector<Log> logs;
        for (std::size_t i = 0; i < 400; ++i) {
            config::RandomStream stream{{seed, 2, 0, i}, config::Purpose::test};
            const double x_m = 450.0 + 100.0 * stream.uniform();
            const double y_m = 450.0 + 100.0 * stream.uniform();
            Log log = log_between(x_m, y_m, x_m + 8.0 * stream.uniform(), y_m + 8.0 * stream.uniform());
            log.diameter2_cm = 40.0 * stream.uniform();
            log.clearance_m = stream.uniform();
            logs.push_back(log);
        }
        return logs;
    }();
    static const LogIndex logs{field, flat().terrain, 0.5, 0.5};
    config::RandomStream stream{{*rc::gen::arbitrary<std::uint32_t>(), 3, 0, 0}, config::Purpose::test};
    const double rock_radius_m = 0.1 + 0.4 * stream.uniform();
    const double angle = 2.0 * std::numbers::pi * stream.uniform();
    const double speed_mps = 3.0 + 12.0 * stream.uniform();
    const Flight flight{place(flat(), 460.0 + 80.0 * stream.uniform(), 460.0 + 80.0 * stream.uniform(),
                              3.0 * stream.uniform()),
                        {speed_mps * std::cos(angle), speed_mps * std::sin(angle), 4.0 * stream.uniform()}};
    constexpr double until_s = 0.8;
    const auto found = logs.first_hit(flight, until_s, rock_radius_m, {}, {});

    const double fastest_mps =
        std::sqrt(std::max(flight.squared_speed_at(0.0), flight.squared_speed_at(until_s)));
    const auto lies = [&](const LogPiece& piece, double time_s) {
        const Eigen::Vector3d centre_m = flight.position_m(time_s) + rock_radius_m * piece.normal;
        const Eigen::Vector3d off_m = centre_m - piece.nearest_to(centre_m);
        constexpr double grazing = 2e-6;
        return Lying{off_m.norm() - rock_radius_m - piece.radius_m,
                     flight.velocity_at(time_s).dot(off_m) < -grazing * fastest_mps * off_m.norm()};
    };
    // Within a log a rock is met as soon as it moves towards it: a centimetre of way earlier it was still
    // within and leaving.
    const auto was_leaving = [&](const LogPiece& piece, double time_s) {
        const double look_again_s = 0.0101 / std::sqrt(flight.squared_speed_at(time_s));
        const Lying before = lies(piece, std::max(0.0, time_s - look_again_s));
        return before.gap_m <= touching_m && !before.moves_towards;
    };
    const double end_s = found ? found->time_s : until_s;
    std::vector<LogPiece> near;  // all that the rock could touch
    for (const LogPiece& piece : logs.pieces()) {
        if (lies(piece, 0.0).gap_m < fastest_mps * end_s + touching_m) {
            near.push_back(piece);
        }
    }
    for (double time_s = 0.0; time_s < end_s - 1e-9; time_s += 4e-3) {
        for (const LogPiece& piece : near) {
            const Lying now = lies(piece, time_s);
            RC_ASSERT(now.gap_m >= 0.0 || !now.moves_towards || was_leaving(piece, time_s));
        }
    }
    if (found) {
        const LogPiece& piece = logs.pieces()[found->piece];
        const double gap_m = lies(piece, found->time_s).gap_m;
        RC_ASSERT(gap_m <= touching_m);
        RC_ASSERT(found->time_s == 0.0 || gap_m >= -1e-9 || was_leaving(piece, found->time_s));
        RC_ASSERT(std::abs(found->towards_rock.norm() - 1.0) < 1e-12);
    }
}

TEST(LogIndex, IsMetFromWithinOnceTheRockFallsBackTowardsIt) {
    // A rock that begins inside a log, its centre 0.4 m above the axis, rises for 0.1 s and by 5 cm only: it
    // is still 15 cm deep when it turns.
    const LogIndex logs{std::vector<Log>{log_between(500.0, 490.0, 500.0, 510.0)}, flat().terrain, radius_m,
                        0.5};
    const double speed_mps = 0.1 * config::gravity_mps2;
    const Flight flight{place(flat(), 500.0, 500.0, 0.2), {0.0, 1.0, speed_mps}};
    const auto hit = logs.first_hit(flight, 1.0, radius_m, {}, {});
    ASSERT_TRUE(hit);
    EXPECT_GE(hit->time_s, 0.1);
    EXPECT_LE(hit->time_s, 0.1 + 0.01);  // a centimetre of way at 1 m/s and more
    EXPECT_NEAR(hit->towards_rock.z(), 1.0, 1e-9);
    // One that moves towards the axis from the start is met there and then; one that gets out is not met.
    const Flight sinking{flight.start_m, {0.0, 1.0, -0.1}};
    EXPECT_EQ(logs.first_hit(sinking, 1.0, radius_m, {}, {}).value().time_s, 0.0);
    const Flight rising{flight.start_m, {0.0, 1.0, 5.0}};
    EXPECT_FALSE(logs.first_hit(rising, 0.5, radius_m, {}, {}));
}

TEST(LogIndex, PassesOverLogsTouchedGoneOrWithoutStrength) {
    Log log = log_between(500.0, 490.0, 500.0, 510.0);
    const LogIndex logs{std::vector<Log>{log}, flat().terrain, radius_m, 0.5};
    const Eigen::Vector3d start_m = place(flat(), 490.0, 500.0, 0.0);
    const Eigen::Vector3d velocity_mps{10.0, 0.0, 0.0};
    const std::vector<std::uint8_t> gone{1};
    EXPECT_FALSE(logs.first_hit_rolling(start_m, velocity_mps, 2.0, radius_m, std::array{0U}, {}));
    EXPECT_FALSE(logs.first_hit_rolling(start_m, velocity_mps, 2.0, radius_m, {}, gone));
    log.strength = 0.0;
    const LogIndex rotten{std::vector<Log>{log}, flat().terrain, radius_m, 0.5};
    EXPECT_EQ(rotten.count(), 1U);
    EXPECT_FALSE(met_rolling(rotten));
}

TEST(LogIndex, KnowsWhenARockHasLeftALog) {
    const LogIndex logs{std::vector<Log>{log_between(500.0, 490.0, 500.0, 510.0)}, flat().terrain, radius_m,
                        0.5};
    const double reach_m = plan_reach_m(radius_m, 0.2);
    EXPECT_FALSE(logs.is_left(0, place(flat(), 500.0 + reach_m, 500.0, 0.0), radius_m));
    EXPECT_TRUE(logs.is_left(0, place(flat(), 500.0 + reach_m + 0.02, 500.0, 0.0), radius_m));
    EXPECT_TRUE(logs.is_left(0, place(flat(), 500.0, 500.0, 0.42), radius_m));
}

TEST(LogIndex, FollowsTheGroundAcrossAGully) {
    const config::GridFrame frame{40, 40, 0.0, 0.0, 2.0, 2.0};
    const Slope gully = testing::slope_over(
        testing::heights_of(frame, [](double, double y) { return 100.0 + 0.5 * std::abs(y - 39.0); }),
        {0.3, 0.75});
    const LogIndex logs{std::vector<Log>{log_between(40.0, 29.0, 40.0, 49.0)}, gully.terrain, radius_m, 0.5};
    for (const double y_m : {33.0, 39.0, 44.0}) {
        EXPECT_TRUE(
            logs.first_hit_rolling(place(gully, 30.0, y_m, 0.0), {10.0, 0.0, 0.0}, 2.0, radius_m, {}, {}))
            << y_m;
    }
}

TEST(LogIndex, LeavesOutWhatHasNoGround) {
    const std::vector<Log> field{log_between(985.0, 500.0, 1005.0, 500.0),
                                 log_between(1100.0, 500.0, 1100.0, 510.0)};
    const LogIndex logs{field, flat().terrain, radius_m, 0.5};
    EXPECT_EQ(logs.count(), 2U);
    EXPECT_EQ(logs.pieces().size(), 5U);  // of ten; the terrain ends at 995 m
    EXPECT_TRUE(logs.is_left(1, place(flat(), 500.0, 500.0, 0.0), radius_m));
}

TEST(LogIndex, HoldsHalfWhereNothingHoldsTheLog) {
    Log loose = log_between(500.0, 490.0, 500.0, 510.0);
    loose.supported = false;
    loose.strength = 0.6;
    loose.fracture_energy = 0.9;
    const LogIndex logs{std::vector<Log>{loose}, flat().terrain, radius_m, 0.5};
    EXPECT_DOUBLE_EQ(logs.pieces()[3].largest_energy_j, 0.6 * 0.5 * largest_energy_j(40.0, 0.9));
}

}  // namespace
}  // namespace rockfall::log_index_test
