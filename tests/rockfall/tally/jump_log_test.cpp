#include "rockfall/tally/jump_log.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rockfall/slope/profile_strip.hpp"
#include "rockfall/tally/footprint.hpp"
#include "tests/rockfall/slopes.hpp"

namespace rockfall::jump_log_test {
namespace {

using testing::deterministic_law;
using testing::EventLog;
using testing::plane_slope;
using testing::start_at;

/// Two observers and the end of one fall.
struct Watched {
    EventLog events;
    JumpLog jumps;
    FallEnd end;

    Watched(const Slope& slope, const FallLaw& law, const RockStart& start, const StemIndex* stems = nullptr)
        : jumps{slope.terrain} {
        FallScratch scratch;
        BothWatch<EventLog, JumpLog> both{events, jumps};
        jumps.begin();
        end = fall(slope, {stems, {}}, law, {1, 0, 0, start.id}, start, scratch, both);
    }
};

TEST(JumpLog, KeepsEachFlightFromItsBeginningToItsEnd) {
    const Slope slope = plane_slope(38.0, {0.30, 0.75}, 0.01, 600.0);
    const Watched fall{slope, FallLaw{}, start_at(slope, 20.0, 50.0, 1.5, {2.6, 0.0, -1.5})};
    ASSERT_EQ(fall.jumps.jumps().size(), fall.events.jumps.size());
    for (std::size_t i = 0; i < fall.events.jumps.size(); ++i) {
        const EventLog::Jump& flown = fall.events.jumps[i];
        const Jump& jump = fall.jumps.jumps()[i];
        EXPECT_EQ(jump.from_m, flown.flight.start_m);
        EXPECT_EQ(jump.to_m, flown.flight.position_m(flown.until_s));
        EXPECT_EQ(jump.time_s, flown.until_s);
        EXPECT_DOUBLE_EQ(jump.launch_mps, flown.flight.velocity_mps.norm());
        EXPECT_DOUBLE_EQ(jump.impact_mps, flown.flight.velocity_at(flown.until_s).norm());
        EXPECT_LE(jump.plan_length_m(), jump.length_m());
    }
}

TEST(JumpLog, KnowsTheHighestPointAboveBrokenGround) {
    // Over an edge the highest place above ground is not the apex of the parabola.
    const std::vector<ProfilePoint> profile{
        {0.0, 60.0, 0}, {20.0, 50.0, 0}, {20.01, 38.0, 0}, {50.0, 30.0, 0}, {90.0, 0.0, 0}};
    SurfaceType ground;
    ground.restitution = {0.35, 0.85};
    const Slope slope = strip_slope(profile, {ground});
    FallLaw law = deterministic_law();
    law.motion.of<picus::Model>().jump_angle.scatter = 0.3;
    for (std::uint64_t rock = 0; rock < 30; ++rock) {
        const Watched fall{slope, law, start_at(slope, 3.0, 0.0, 1.5, {3.0, 0.0, -1.5}, 0.95, rock)};
        for (std::size_t i = 0; i < fall.events.jumps.size(); ++i) {
            const EventLog::Jump& flown = fall.events.jumps[i];
            double highest_m = 0.0;
            for (int k = 0; k <= 2000; ++k) {
                const Eigen::Vector3d p = flown.flight.position_m(flown.until_s * k / 2000.0);
                highest_m = std::max(highest_m, p.z() - slope.terrain.height_m(p.x(), p.y()).value_or(p.z()));
            }
            EXPECT_NEAR(fall.jumps.jumps()[i].highest_m, highest_m, 0.02) << rock << ' ' << i;
        }
    }
}

TEST(JumpLog, AgreesWithTheRecordOfTheRock) {
    const Slope slope = plane_slope(35.0, {0.30, 0.78}, 0.01, 600.0);
    const config::GridFrame frame{60,   10,  -slope.terrain.origin_m().x(), -slope.terrain.origin_m().y(),
                                  10.0, 10.0};
    Footprint footprint{slope.terrain, frame, {}};
    JumpLog log{slope.terrain};
    FallScratch scratch;
    for (std::uint64_t rock = 0; rock < 50; ++rock) {
        const RockStart start = start_at(slope, 20.0, 50.0, 1.5, {2.6, 0.0, -1.5}, 0.95, rock);
        footprint.begin(start, false);
        log.begin();
        BothWatch<Footprint, JumpLog> both{footprint, log};
        footprint.finish(fall(slope, {}, FallLaw{}, {1, 0, 0, rock}, start, scratch, both));
        double height_sum_m = 0.0;
        for (const Jump& jump : log.jumps()) {
            height_sum_m += jump.highest_m;
        }
        EXPECT_EQ(log.jumps().size(), footprint.record().jumps);
        EXPECT_DOUBLE_EQ(height_sum_m, footprint.record().jump_height_sum_m);
    }
}

TEST(JumpLog, CallsLandedWhatEndedOnTheGround) {
    const Slope slope = plane_slope(38.0, {0.30, 0.75}, 0.0, 100.0);
    const Watched fall{slope, deterministic_law(), start_at(slope, 20.0, 50.0, 1.5, {2.6, 0.0, -1.5})};
    ASSERT_EQ(fall.end.reason, StopReason::left_terrain);
    const auto jumps = fall.jumps.jumps();
    ASSERT_GT(jumps.size(), 5U);
    std::size_t landed = 0;
    for (const Jump& jump : jumps) {
        landed += jump.landed ? 1 : 0;
    }
    EXPECT_EQ(landed, fall.end.ground_impacts);
    EXPECT_FALSE(jumps.back().landed);  // over the border
    EXPECT_EQ(landed, jumps.size() - 1);
}

TEST(JumpLog, DoesNotTakeARollingRocksImpactForTheEndOfAJump) {
    // Flies into a stem, drops to the ground, rolls on, runs into a rising face: the flight ended at the
    // stem.
    const Slope slope = plane_slope(30.0, {0.30, 0.75});
    JumpLog log{slope.terrain};
    log.begin();
    const RockStart start = start_at(slope, 20.0, 50.0, 1.5, {2.6, 0.0, -1.5});
    std::vector<Stretch> stretches;
    const Flight flight{start.position_m, start.velocity_mps};
    const Landing landing = fly(slope.terrain, flight, start.triangle, stretches);
    log.flew(start.rock, flight, landing.time_s, stretches, 0.0);
    log.met_stem(start.position_m, {}, {}, 1.0);
    log.impacted(start.position_m, 0);
    EXPECT_FALSE(log.jumps().back().landed);
    log.flew(start.rock, flight, landing.time_s, stretches, 0.0);
    log.rolled(start.rock, {}, landing.triangle);
    log.impacted(start.position_m, 0);
    EXPECT_FALSE(log.jumps().back().landed);
    log.flew(start.rock, flight, landing.time_s, stretches, 0.0);
    log.impacted(start.position_m, 0);
    EXPECT_TRUE(log.jumps().back().landed);
}

TEST(JumpLog, BeginsEachRockAnew) {
    const Slope slope = plane_slope(38.0, {0.30, 0.75}, 0.0, 100.0);
    const RockStart start = start_at(slope, 20.0, 50.0, 1.5, {2.6, 0.0, -1.5});
    Watched fall{slope, deterministic_law(), start};
    fall.jumps.begin();
    EXPECT_TRUE(fall.jumps.jumps().empty());
    fall.jumps.impacted(start.position_m, 0);  // without a flight there is nothing to mark
    EXPECT_TRUE(fall.jumps.jumps().empty());
}

}  // namespace
}  // namespace rockfall::jump_log_test
