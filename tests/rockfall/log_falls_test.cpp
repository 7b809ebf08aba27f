// Whole falls over lying logs.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "rockfall/obstacles/log_index.hpp"
#include "tests/rockfall/slopes.hpp"

namespace rockfall::log_falls_test {
namespace {

using testing::deterministic_law;
using testing::EventLog;
using testing::logged_fall;
using testing::plane_slope;
using testing::start_at;

FallLaw lively_law() {
    FallLaw law;
    law.tree.deviation = deterministic_law().tree.deviation;
    return law;
}

Log log_at(double x_m, double y_m, double length_m, double angle_rad, double diameter_cm, double clearance_m,
           bool supported = true) {
    const double dx = 0.5 * length_m * std::cos(angle_rad);
    const double dy = 0.5 * length_m * std::sin(angle_rad);
    return {.x1_m = x_m - dx,
            .y1_m = y_m - dy,
            .x2_m = x_m + dx,
            .y2_m = y_m + dy,
            .diameter1_cm = diameter_cm,
            .diameter2_cm = diameter_cm,
            .clearance_m = clearance_m,
            .supported = supported};
}

constexpr double across = 0.5 * std::numbers::pi;

/// Logs all over a strip of a slope, any direction.
std::vector<Log> random_logs(std::uint64_t seed, std::size_t count, double east_m, double north_m) {
    std::vector<Log> logs;
    for (std::size_t i = 0; i < count; ++i) {
        config::RandomStream stream{{seed, 5, 0, i}, config::Purpose::test};
        Log log = log_at(30.0 + (east_m - 40.0) * stream.uniform(), north_m * stream.uniform(),
                         2.0 + 13.0 * stream.uniform(), std::numbers::pi * stream.uniform(),
                         15.0 + 45.0 * stream.uniform(), std::max(0.0, stream.uniform() - 0.4),
                         stream.uniform() < 0.5);
        log.diameter2_cm = 10.0 + 30.0 * stream.uniform();
        log.strength = stream.uniform();
        logs.push_back(log);
    }
    return logs;
}

Slope rough_slope(std::uint64_t seed) {
    config::RandomStream shape{{seed, 0, 0, 0}, config::Purpose::test};
    const double tangent = 0.3 + 0.7 * shape.uniform();
    const double wave_m = 4.0 * shape.uniform();
    const config::GridFrame frame{60, 40, 0.0, 0.0, 5.0, 5.0};
    std::uint64_t k = 0;
    return testing::slope_over(
        testing::heights_of(frame,
                            [&](double x, double y) {
                                config::RandomStream cell{{seed, 1, 0, k++}, config::Purpose::test};
                                return 500.0 - tangent * x + wave_m * std::sin(y / 8.0) +
                                       0.5 * cell.uniform();
                            }),
        {0.35, 0.85}, 0.002);
}

RC_GTEST_PROP(FallOverLogs, NeverGainsEnergyAndEnds, ()) {
    const auto seed = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000));
    const Slope slope = rough_slope(seed);
    const LogIndex logs{random_logs(seed, 400, 300.0, 200.0), slope.terrain, 0.5, 0.5};
    const RockStart start = start_at(slope, 20.0, 100.0, 1.5, {3.0, 0.5, -1.5}, 0.9, seed);
    const auto [end, events] = logged_fall(slope, lively_law(), start, Obstacles{.logs = &logs});
    RC_ASSERT(end.reason != StopReason::gave_up);
    RC_ASSERT(end.log_hits == events.logs.size());
    for (const EventLog::Met& met : events.logs) {
        RC_ASSERT(met.impact.loss_j >= 0.0);
        RC_ASSERT(met.impact.loss_j <= met.energy_j * (1.0 + 1e-12));
    }
    const auto energy_per_kg = [&](const EventLog::Jump& jump) {
        return kinetic_energy_j(start.rock, jump.flight.velocity_mps.squaredNorm(), jump.spin_radps) /
                   start.rock.mass_kg +
               9.81 * jump.flight.start_m.z();
    };
    double last = kinetic_energy_j(start.rock, start.velocity_mps.squaredNorm(), 0.0) / start.rock.mass_kg +
                  9.81 * start.position_m.z();
    for (const EventLog::Jump& jump : events.jumps) {
        const double now = energy_per_kg(jump);
        RC_ASSERT(now <= last + 1e-6);
        last = now;
    }
}

TEST(FallOverLogs, StopsASlowRockUpslopeOfALogAcrossItsWay) {
    const Slope slope = plane_slope(30.0, {0.30, 0.75});
    const LogIndex logs{std::vector<Log>{log_at(130.0, 50.0, 20.0, across, 50.0, 0.0)}, slope.terrain, 0.5,
                        0.5};
    int stopped = 0;
    for (std::uint64_t rock = 0; rock < 100; ++rock) {
        const auto [end, events] =
            logged_fall(slope, lively_law(), start_at(slope, 128.0, 50.0, 0.0, {1.0, 0.0, -0.577}, 0.5, rock),
                        Obstacles{.logs = &logs});
        if (end.reason == StopReason::log) {
            ++stopped;
            const double x_m = end.position_m.x() + slope.terrain.origin_m().x();
            EXPECT_LT(x_m, 130.0);
            EXPECT_GT(x_m, 129.0);
        }
    }
    EXPECT_GE(stopped, 95);
}

TEST(FallOverLogs, IsNotChangedByLogsThatItJumpsOverOrThatHaveRotted) {
    const Slope slope = plane_slope(35.0, {0.30, 0.80});
    const RockStart start = start_at(slope, 100.0, 50.0, 20.0, {8.0, 0.0, 2.0}, 0.9);
    const auto [bare, bare_events] = logged_fall(slope, lively_law(), start);
    std::vector<Log> low{log_at(103.0, 50.0, 20.0, across, 60.0, 0.5)};
    std::vector<Log> rotten{log_at(200.0, 50.0, 90.0, across, 60.0, 0.0)};
    rotten[0].strength = 0.0;
    for (const std::vector<Log>& field : {low, rotten}) {
        const LogIndex logs{field, slope.terrain, 0.5, 0.5};
        const auto [end, events] = logged_fall(slope, lively_law(), start, Obstacles{.logs = &logs});
        EXPECT_TRUE(events.logs.empty());
        EXPECT_EQ(end.position_m, bare.position_m);
    }
}

TEST(FallOverLogs, PassesBelowALogAndGoesOn) {
    const Slope slope = plane_slope(20.0, {0.30, 0.75});
    FallLaw law = deterministic_law();
    law.motion.of<picus::Model>().rolling.friction = 0.3;  // rolls on at 20 degrees
    law.motion.of<picus::Model>().rolling.launch_factor = 1e9;
    for (const double clearance_m : {0.4, 0.6}) {
        const LogIndex logs{std::vector<Log>{log_at(130.0, 50.0, 20.0, across, 50.0, clearance_m)},
                            slope.terrain, 0.25, 0.5};
        const auto [end, events] = logged_fall(
            slope, law, start_at(slope, 120.0, 50.0, 0.0, {1.0, 0.0, -0.364}, 0.5), Obstacles{.logs = &logs});
        EXPECT_EQ(end.reason, clearance_m < 0.5 ? StopReason::log : StopReason::left_terrain) << clearance_m;
    }
}

TEST(FallOverLogs, MirrorsItself) {
    const Slope slope = plane_slope(30.0, {0.30, 0.75}, 0.0, 400.0, 100.0);
    for (const double angle : {0.4, 1.0, 1.4}) {
        const LogIndex one{std::vector<Log>{log_at(130.0, 50.0, 12.0, angle, 50.0, 0.1)}, slope.terrain, 0.5,
                           0.5};
        const LogIndex other{std::vector<Log>{log_at(130.0, 50.0, 12.0, -angle, 50.0, 0.1)}, slope.terrain,
                             0.5, 0.5};
        const double origin_y_m = slope.terrain.origin_m().y();
        for (const double aside_m : {-1.0, 0.3, 2.0}) {
            const auto [a, events_a] = logged_fall(
                slope, deterministic_law(),
                start_at(slope, 118.0, 50.0 + aside_m, 1.0, {5.0, 0.4, -2.0}, 0.6), Obstacles{.logs = &one});
            const auto [b, events_b] =
                logged_fall(slope, deterministic_law(),
                            start_at(slope, 118.0, 50.0 - aside_m, 1.0, {5.0, -0.4, -2.0}, 0.6),
                            Obstacles{.logs = &other});
            EXPECT_EQ(a.reason, b.reason);
            EXPECT_EQ(events_a.logs.size(), events_b.logs.size());
            EXPECT_NEAR(a.position_m.x(), b.position_m.x(), 1e-6);
            EXPECT_NEAR(a.position_m.y() + origin_y_m - 50.0, 50.0 - b.position_m.y() - origin_y_m, 1e-6);
        }
    }
}

TEST(FallOverLogs, BreaksALogForTheRocksThatFollowOnlyIfAsked) {
    const Slope slope = plane_slope(38.0, {0.30, 0.75});
    const LogIndex logs{std::vector<Log>{log_at(112.0, 50.0, 60.0, across, 12.0, 0.5)}, slope.terrain, 1.0,
                        0.5};
    FallLaw law = deterministic_law();
    for (const bool remove : {false, true}) {
        law.tree.remove_broken = remove;
        std::vector<std::uint8_t> gone(1, 0);
        const auto [end, events] =
            logged_fall(slope, law, start_at(slope, 100.0, 50.0, 0.5, {8.0, 0.0, -6.0}, 1.5),
                        Obstacles{.logs = &logs, .logs_gone = gone});
        ASSERT_FALSE(events.logs.empty());
        EXPECT_EQ(events.logs[0].impact.outcome, LogOutcome::broke);
        EXPECT_EQ(gone[0], remove ? 1 : 0);
    }
}

/// How a slope of 35 degrees and 300 m with 300 stems per hectare of 25 cm holds rocks of 45 kg, by what lies
/// on it.
struct Passage {
    double passed;     ///< share that comes further than 50 m
    double run_out_m;  ///< mean plan distance of all
    double at_log;     ///< share that rests at a log
};

Passage passage_of(const std::vector<Log>& field, bool with_trees) {
    static const Slope slope = plane_slope(35.0, {0.32, 0.80}, 0.01, 300.0, 200.0);
    constexpr double diameter_m = 0.317;  // 45 kg at 2700 kg/m3
    std::vector<Stem> trees;
    for (std::size_t i = 0; with_trees && i < 1800; ++i) {
        config::RandomStream stream{{7, 6, 0, i}, config::Purpose::test};
        trees.push_back({300.0 * stream.uniform(), 200.0 * stream.uniform(), 25.0, 20.0, 0.9});
    }
    const StemIndex stems{trees, slope.terrain, diameter_m, true};
    const LogIndex logs{field, slope.terrain, diameter_m, 0.5};
    Passage passage{0.0, 0.0, 0.0};
    constexpr int rocks = 2000;
    for (std::uint64_t rock = 0; rock < rocks; ++rock) {
        config::RandomStream place{{8, 6, 0, rock}, config::Purpose::test};
        const RockStart start =
            start_at(slope, 15.0, 60.0 + 80.0 * place.uniform(), 1.0, {2.5, 0.0, -1.0}, diameter_m, rock);
        const auto [end, events] =
            logged_fall(slope, lively_law(), start, Obstacles{.stems = &stems, .logs = &logs});
        const double way_m = (end.position_m - start.position_m).head<2>().norm();
        passage.passed += (way_m > 50.0 ? 1.0 : 0.0) / rocks;
        passage.run_out_m += way_m / rocks;
        passage.at_log += (end.reason == StopReason::log ? 1.0 : 0.0) / rocks;
    }
    return passage;
}

/// So many logs per hectare of 25 cm and 12 m, any direction, with clearances up to 0.45 m; 73 % of them
/// held.
std::vector<Log> windthrow_of(std::size_t logs_per_ha) {
    constexpr std::size_t hectares = 6;
    std::vector<Log> windthrow;
    for (std::size_t i = 0; i < hectares * logs_per_ha; ++i) {
        config::RandomStream stream{{7, 7, 0, i}, config::Purpose::test};
        windthrow.push_back(log_at(300.0 * stream.uniform(), 200.0 * stream.uniform(), 12.0,
                                   std::numbers::pi * stream.uniform(), 25.0, 0.45 * stream.uniform(),
                                   stream.uniform() < 0.73));
    }
    return windthrow;
}

TEST(FallOverLogs, FreshWindthrowHoldsSmallRocksThatThePlainStandLetsPass) {
    // Ringenbach et al. 2022 (NHESS 22:2433), 45 kg in a spruce stand: with fresh logs 3.6 % pass the section
    // and the mean run-out is 42 % shorter; once cleared it is 17 % longer than in the stand before. Only the
    // directions are required here: stand, slope and lie of their logs are not public.
    const Passage stand = passage_of({}, true);
    const Passage cleared = passage_of({}, false);
    const auto print = [&](const std::string& name, const Passage& p) {
        std::printf("%-16s passes 50 m: %5.1f %%, mean run-out %5.1f m (%+.0f %%), rests at a log %5.1f %%\n",
                    name.c_str(), 100.0 * p.passed, p.run_out_m,
                    100.0 * (p.run_out_m / stand.run_out_m - 1.0), 100.0 * p.at_log);
    };
    print("300 trees per ha", stand);
    print("cleared", cleared);
    double last_m = cleared.run_out_m;
    for (const std::size_t logs_per_ha : {25U, 50U, 100U, 200U, 300U}) {
        const Passage fresh = passage_of(windthrow_of(logs_per_ha), false);
        print(std::to_string(logs_per_ha) + " logs per ha", fresh);
        EXPECT_LT(fresh.run_out_m, last_m);
        last_m = fresh.run_out_m;
        if (logs_per_ha >= 100) {
            EXPECT_LT(fresh.passed, (logs_per_ha >= 200 ? 0.5 : 1.0) * stand.passed);
            EXPECT_LT(fresh.run_out_m, stand.run_out_m);
            EXPECT_GT(fresh.at_log, 0.5);
        }
    }
    EXPECT_GT(cleared.run_out_m, stand.run_out_m);
    EXPECT_EQ(stand.at_log, 0.0);
}

}  // namespace
}  // namespace rockfall::log_falls_test
