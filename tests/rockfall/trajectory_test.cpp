#include "rockfall/trajectory.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "config/random/distributions.hpp"
#include "tests/rockfall/slopes.hpp"

namespace rockfall::trajectory_test {
namespace {

using testing::deterministic_law;
using testing::EventLog;
using testing::heights_of;
using testing::logged_fall;
using testing::plane_slope;
using testing::slope_over;
using testing::start_at;

/// Everything random at full strength.
FallLaw lively_law(MotionModel model = motion_model<picus::Model>) {
    FallLaw law;
    law.motion.model = model;
    law.tree.deviation = deterministic_law().tree.deviation;
    return law;
}

/// Rules that hold for falls hold under every motion model.
rc::Gen<MotionModel> any_model() {
    return rc::gen::elementOf(all_models());
}

/// A rough slope: a plane with waves, steps and noise, different for each seed.
Slope rough_slope(std::uint64_t seed, double noise_m) {
    config::RandomStream shape{{seed, 0, 0, 0}, config::Purpose::test};
    const double tangent = 0.2 + 0.9 * shape.uniform();
    const double wave_m = 6.0 * shape.uniform();
    const double length_m = 20.0 + 60.0 * shape.uniform();
    const double cliff_m = 40.0 * shape.uniform();
    const config::GridFrame frame{60, 40, 0.0, 0.0, 5.0, 5.0};
    std::uint64_t k = 0;
    return slope_over(heights_of(frame,
                                 [&](double x, double y) {
                                     config::RandomStream cell{{seed, 1, 0, k++}, config::Purpose::test};
                                     return 500.0 - tangent * x + wave_m * std::sin(y / length_m * 6.28) +
                                            (x < 100.0 ? cliff_m : 0.0) +
                                            noise_m * (2.0 * cell.uniform() - 1.0);
                                 }),
                      {0.35, 0.85}, 0.005);
}

std::vector<Stem> stems_on(std::uint64_t seed, std::size_t count) {
    std::vector<Stem> stems;
    for (std::size_t i = 0; i < count; ++i) {
        config::RandomStream stream{{seed, 2, 0, i}, config::Purpose::test};
        stems.push_back({10.0 + 280.0 * stream.uniform(), 10.0 + 180.0 * stream.uniform(),
                         10.0 + 50.0 * stream.uniform(), 5.0 + 30.0 * stream.uniform(), 1.0});
    }
    return stems;
}

double energy_per_mass(const Rock& rock, const Eigen::Vector3d& velocity, double spin, double height) {
    return kinetic_energy_j(rock, velocity.squaredNorm(), spin) / rock.mass_kg + 9.81 * height;
}

RC_GTEST_PROP(FallOnRoughGround, KeepsItsEnergyInFlightAndNeverGainsAny, ()) {
    const auto seed = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000));
    const FallLaw law = lively_law(*any_model());
    const Slope slope = rough_slope(seed, 0.5);
    const StemIndex stems{stems_on(seed, 600), slope.terrain, 0.5, true};
    const RockStart start = start_at(slope, 20.0, 100.0, 1.5, {3.0, 0.5, -1.5}, 0.9, seed);
    const auto [end, log] = logged_fall(slope, law, start, &stems);
    // Total mechanical energy per mass at the start of each flight, in order: contacts and hits only take.
    double last = energy_per_mass(start.rock, start.velocity_mps, 0.0, start.position_m.z());
    for (const EventLog::Jump& jump : log.jumps) {
        const double begin =
            energy_per_mass(start.rock, jump.flight.velocity_mps, jump.spin_radps, jump.flight.start_m.z());
        const double finish = energy_per_mass(start.rock, jump.flight.velocity_at(jump.until_s),
                                              jump.spin_radps, jump.flight.height_m(jump.until_s));
        RC_ASSERT(std::abs(begin - finish) <= 1e-9 * std::max(1.0, std::abs(begin)));
        RC_ASSERT(begin <= last + 1e-6);
        last = begin;
    }
}

RC_GTEST_PROP(FallOnRoughGround, NeverGoesBelowTheSurface, ()) {
    const auto seed = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000));
    const FallLaw law = lively_law(*any_model());
    const Slope slope = rough_slope(seed, 1.0);
    const RockStart start = start_at(slope, 20.0, 100.0, 1.5, {3.0, 0.5, -1.5}, 0.9, seed);
    const auto [end, log] = logged_fall(slope, law, start);
    RC_ASSERT(end.position_m.allFinite());
    for (const EventLog::Jump& jump : log.jumps) {
        RC_ASSERT(jump.flight.velocity_mps.allFinite());
        for (int i = 1; i < 20; ++i) {
            const double time_s = jump.until_s * i / 20.0;
            const Eigen::Vector3d p = jump.flight.position_m(time_s);
            const auto ground_m = slope.terrain.height_m(p.x(), p.y());
            RC_ASSERT(ground_m.has_value());
            RC_ASSERT(p.z() >= *ground_m - 1e-6);
        }
    }
}

RC_GTEST_PROP(FallOnRoughGround, EndsAndMovesBetweenItsImpacts, ()) {
    // A rock that lands on the edge that it leaves, again and again, once stopped 4 % of all rocks on even
    // ground.
    const auto seed = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000));
    const FallLaw law = lively_law(*any_model());
    const Slope slope = rough_slope(seed, 0.1);
    const RockStart start = start_at(slope, 20.0, 100.0, 1.5, {3.0, 0.5, -1.5}, 0.9, seed);
    const auto [end, log] = logged_fall(slope, law, start);
    RC_ASSERT(end.reason != StopReason::gave_up);
    int without_time = 0;
    for (const EventLog::Jump& jump : log.jumps) {
        without_time = jump.until_s < 1e-9 ? without_time + 1 : 0;
        // A turned rock may strike both faces of a groove, but the third time the groove leads it on.
        RC_ASSERT(without_time < 3);
    }
}

TEST(Fall, GoesOnForEverOnSteepEvenGround) {
    // 38 degrees is far above the critical slope of r_t = 0.75: only the border ends it, whatever the mesh
    // looks like.
    const Slope slope = plane_slope(38.0, {0.30, 0.75}, 0.0, 600.0);
    for (std::uint64_t rock = 0; rock < 300; ++rock) {
        const auto [end, log] =
            logged_fall(slope, lively_law(), start_at(slope, 20.0, 50.0, 1.5, {2.6, 0.0, -1.5}, 0.95, rock));
        EXPECT_EQ(end.reason, StopReason::left_terrain) << rock;
    }
}

TEST(Fall, HitsTheGroundWhereAFineSearchSaysSo) {
    const Slope slope = rough_slope(3, 1.0);
    const RockStart start = start_at(slope, 20.0, 100.0, 12.0, {9.0, 2.0, 4.0});
    std::vector<Stretch> stretches;
    const Flight flight{start.position_m, start.velocity_mps};
    const Landing landing = fly(slope.terrain, flight, start.triangle, stretches);
    double time_s = 0.0;
    constexpr double step_s = 1e-4;
    while (true) {
        const Eigen::Vector3d p = flight.position_m(time_s);
        if (p.z() < slope.terrain.height_m(p.x(), p.y()).value()) {
            break;
        }
        time_s += step_s;
    }
    EXPECT_NEAR(landing.time_s, time_s, 1.1 * step_s);
}

TEST(Fall, ComesToRestOnFlatGroundInsteadOfBouncingByMillimetres) {
    const Slope flat = plane_slope(0.0, {0.50, 0.90});
    const auto [end, log] =
        logged_fall(flat, lively_law(), start_at(flat, 100.0, 50.0, 10.0, {5.0, 0.0, 0.0}));
    EXPECT_EQ(end.reason, StopReason::at_rest);
    EXPECT_LT(end.ground_impacts, 40U);
}

TEST(Fall, RestsInAPitWithSteepWalls) {
    const config::GridFrame frame{20, 20, 0.0, 0.0, 5.0, 5.0};
    const Slope pit =
        slope_over(heights_of(frame, [](double x, double y) { return 1.2 * std::hypot(x - 50.0, y - 50.0); }),
                   {0.35, 0.85});
    for (const MotionModel model : all_models()) {
        const auto [end, log] =
            logged_fall(pit, lively_law(model), start_at(pit, 30.0, 40.0, 1.5, {3.0, 0.0, -1.0}));
        EXPECT_EQ(end.reason, StopReason::at_rest);
        EXPECT_LT(end.ground_impacts, 400U);
        EXPECT_LT((end.position_m.head<2>() + pit.terrain.origin_m() - Eigen::Vector2d{50.0, 50.0}).norm(),
                  8.0);
    }
}

TEST(Fall, FollowsAGullyDownhill) {
    const config::GridFrame frame{60, 20, 0.0, 0.0, 5.0, 5.0};
    const Slope gully = slope_over(
        heights_of(frame, [](double x, double y) { return 400.0 - 0.8 * x + 1.0 * std::abs(y - 47.5); }),
        {0.30, 0.65});
    for (const MotionModel model : all_models()) {
        FallLaw law = lively_law(model);
        law.motion.of<picus::Model>().stopping.by_chance = false;
        int left = 0;
        constexpr int rocks = 100;
        for (std::uint64_t rock = 0; rock < rocks; ++rock) {
            const auto [end, log] =
                logged_fall(gully, law, start_at(gully, 20.0, 70.0, 1.0, {1.0, -1.0, 0.0}, 0.8, rock));
            left += end.reason == StopReason::left_terrain ? 1 : 0;
        }
        EXPECT_EQ(left,
                  rocks);  // the floor falls by 38 degrees, more than any friction here: nothing holds a rock
    }
}

TEST(Fall, LeavesTheTerrainAsAnOutcome) {
    const Slope slope = plane_slope(38.0, {0.30, 0.75}, 0.0, 100.0);
    const auto [end, log] =
        logged_fall(slope, lively_law(), start_at(slope, 20.0, 50.0, 1.5, {2.6, 0.0, -1.5}));
    EXPECT_EQ(end.reason, StopReason::left_terrain);
    EXPECT_NEAR(end.position_m.x() + slope.terrain.origin_m().x(), 95.0, 1e-6);  // the last cell centre
}

TEST(Fall, EndsAfterTheLargestNumberOfImpacts) {
    const Slope slope = plane_slope(38.0, {0.30, 0.75}, 0.0, 1000.0);
    FallLaw law = lively_law();
    law.motion.of<picus::Model>().stopping.most_impacts = 10;
    const auto [end, log] = logged_fall(slope, law, start_at(slope, 20.0, 50.0, 1.5, {2.6, 0.0, -1.5}));
    EXPECT_EQ(end.reason, StopReason::gave_up);
    EXPECT_EQ(end.ground_impacts, 10U);
}

TEST(Fall, IsStoppedByChanceAsOftenAsItsSurfaceSays) {
    constexpr double p = 0.05;
    const Slope slope = plane_slope(38.0, {0.30, 0.75}, p, 1000.0);
    std::uint64_t impacts = 0;
    std::uint64_t caught = 0;
    for (std::uint64_t rock = 0; rock < 2000; ++rock) {
        const auto [end, log] =
            logged_fall(slope, lively_law(), start_at(slope, 20.0, 50.0, 1.5, {2.6, 0.0, -1.5}, 0.95, rock));
        impacts += end.ground_impacts;
        caught += end.reason == StopReason::caught ? 1 : 0;
    }
    const double share = static_cast<double>(caught) / static_cast<double>(impacts);
    EXPECT_NEAR(share, p, 4.0 * std::sqrt(p * (1.0 - p) / static_cast<double>(impacts)));
}

TEST(Fall, SpreadsAsWideAsTheFieldReports) {
    // 95 % of the rocks within 10 to 20 % of the slope length (Azzoni & de Freitas 1995). Of 2000 rocks the
    // width between the outer quantiles has a standard error of 2.2 %.
    const Slope slope = plane_slope(38.0, {0.30, 0.75}, 0.0, 400.0, 400.0);
    std::vector<double> across;
    for (std::uint64_t rock = 0; rock < 2000; ++rock) {
        const auto [end, log] = logged_fall(slope, lively_law(),
                                            start_at(slope, 100.0, 200.0, 1.5, {2.6, 0.0, -1.5}, 0.95, rock));
        across.push_back(end.position_m.y());
    }
    std::sort(across.begin(), across.end());
    const double width_m = across[1949] - across[50];
    const double slope_length_m = 295.0 / std::cos(config::Angle::from_degrees(38.0).in_radians());
    constexpr double two_errors = 2.0 * 0.022;
    EXPECT_GT(width_m / slope_length_m, 0.10 * (1.0 - two_errors));
    EXPECT_LT(width_m / slope_length_m, 0.20 * (1.0 + two_errors));
}

TEST(Fall, HitsTreesWhileRolling) {
    const Slope slope = plane_slope(20.0, {0.30, 0.75});
    const StemIndex stems{std::vector<Stem>{{105.0, 50.0, 60.0, 25.0, 1.0}}, slope.terrain, 0.5, false};
    const double b = config::Angle::from_degrees(20.0).in_radians();
    const RockStart start =
        start_at(slope, 100.0, 50.0, 0.0, 1.5 * Eigen::Vector3d{std::cos(b), 0.0, -std::sin(b)});
    FallLaw law = deterministic_law();
    law.motion.of<picus::Model>().rolling.friction = 0.3;  // rolls on at 20 degrees
    law.motion.of<picus::Model>().rolling.launch_factor = 1e9;
    const auto [end, log] = logged_fall(slope, law, start, &stems);
    ASSERT_EQ(log.hits.size(), 1U);
    EXPECT_EQ(end.reason, StopReason::tree);
    EXPECT_NEAR(log.hits[0].hit.height_m, 0.475 + 0.775 * std::tan(b),
                0.01);  // centre above the ground at the stem
    EXPECT_NEAR((start.position_m - end.position_m).head<2>().norm(), 5.0 - 0.475 - 0.30, 0.01);
}

TEST(Fall, MeetsTwoTouchingStemsOnceEach) {
    // Within reach of both it once hit one and the other in turn, hundreds of times on one spot.
    const Slope slope = plane_slope(38.0, {0.30, 0.75});
    const StemIndex stems{std::vector<Stem>{{110.0, 49.5, 30.0, 20.0, 1.0}, {110.0, 50.5, 30.0, 20.0, 1.0}},
                          slope.terrain, 0.5, false};
    for (std::uint64_t rock = 0; rock < 200; ++rock) {
        const RockStart start = start_at(slope, 100.0, 49.8 + 0.002 * static_cast<double>(rock), 1.0,
                                         {12.0, 0.0, -6.0}, 0.95, rock);
        const auto [end, log] = logged_fall(slope, lively_law(), start, &stems);
        EXPECT_LE(log.hits.size(), 4U) << rock;
    }
}

TEST(Fall, GetsThroughAThicketInWhichItTouchesDozensOfStems) {
    // Each stem counts again only a centimetre after the rock was clear of it: once on the way, a few times
    // for a rock that is thrown about. More stems than a memory holds once kept a rock for ever.
    const Slope slope = plane_slope(38.0, {0.30, 0.75});
    std::vector<Stem> thicket;
    for (int i = 0; i < 8; ++i) {
        for (int j = 0; j < 8; ++j) {
            thicket.push_back({110.0 + 0.4 * i, 48.6 + 0.4 * j, 5.5, 5.0, 1.0});
        }
    }
    const StemIndex stems{thicket, slope.terrain, 1.25, false};
    for (std::uint64_t rock = 0; rock < 50; ++rock) {
        const RockStart start = start_at(slope, 100.0, 49.0 + 0.04 * static_cast<double>(rock), 1.5,
                                         {12.0, 0.0, -6.0}, 2.5, rock);
        const auto [end, log] = logged_fall(slope, lively_law(), start, &stems);
        EXPECT_GT(log.hits.size(), 12U) << rock;
        EXPECT_LE(log.hits.size(), 4U * thicket.size()) << rock;
    }
}

TEST(Fall, RemovesBrokenTreesOnlyIfAsked) {
    const Slope slope = plane_slope(38.0, {0.30, 0.75});
    const std::vector<Stem> thin{{140.0, 50.0, 12.0, 12.0, 1.0}};
    const StemIndex stems{thin, slope.terrain, 1.0, false};
    FallLaw law = deterministic_law();
    for (const bool remove : {false, true}) {
        law.tree.remove_broken = remove;
        std::vector<std::uint8_t> gone(1, 0);
        const auto [end, log] = logged_fall(
            slope, law, start_at(slope, 100.0, 50.0, 1.0, {8.0, 0.0, -3.0}, 1.5), &stems, 1, gone);
        ASSERT_EQ(log.hits.size(), 1U);
        EXPECT_TRUE(log.hits[0].impact.broken);
        EXPECT_EQ(gone[0], remove ? 1 : 0);
    }
}

TEST(Fall, DependsOnItsKeyAlone) {
    const Slope slope = rough_slope(9, 0.5);
    const RockStart start = start_at(slope, 20.0, 100.0, 1.5, {3.0, 0.5, -1.5});
    const auto [a, log_a] = logged_fall(slope, lively_law(), start, nullptr, 5);
    const auto [b, log_b] = logged_fall(slope, lively_law(), start, nullptr, 5);
    const auto [c, log_c] = logged_fall(slope, lively_law(), start, nullptr, 6);
    EXPECT_EQ(a.position_m, b.position_m);
    EXPECT_NE(a.position_m, c.position_m);
}

}  // namespace
}  // namespace rockfall::trajectory_test
