#include "rockfall/tally/impact_log.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rockfall/trajectory.hpp"
#include "tests/rockfall/slopes.hpp"

namespace rockfall::impact_log_test {
namespace {

using testing::deterministic_law;
using testing::plane_slope;
using testing::start_at;

std::vector<GroundImpact> impacts_on(const Slope& slope, const FallLaw& law, const RockStart& start,
                                     FallEnd* end = nullptr) {
    ImpactLog log{slope};
    FallScratch scratch;
    log.begin();
    const FallEnd found = fall(slope, {}, law, {1, 0, 0, start.id}, start, scratch, log);
    if (end != nullptr) {
        *end = found;
    }
    return {log.impacts().begin(), log.impacts().end()};
}

TEST(ImpactLog, MeetsAFreeFallOntoALevelPlane) {
    // Dropped 5 m at rest: v = sqrt(2 g h) straight down.
    const Slope slope = plane_slope(0.0, {0.30, 0.75}, 0.0, 200.0);
    const auto impacts =
        impacts_on(slope, deterministic_law(), start_at(slope, 20.0, 50.0, 5.0, {0.0, 0.0, 0.0}));
    ASSERT_FALSE(impacts.empty());
    EXPECT_NEAR(impacts[0].before.normal_mps, std::sqrt(2.0 * 9.81 * 5.0), 0.01);
    EXPECT_NEAR(impacts[0].before.along_mps, 0.0, 1e-9);
    EXPECT_NEAR(impacts[0].jump.highest_m, 5.0, 1e-9);
    EXPECT_NEAR(impacts[0].jump.plan_length_m(), 0.0, 1e-9);
}

TEST(ImpactLog, LeavesAtTheAngleOfTheLaw) {
    // Rammer et al. 2010, Eq. 9 on an even slope: the angle of the take-off against its face.
    const Slope slope = plane_slope(38.0, {0.30, 0.75}, 0.0, 600.0);
    FallLaw law = deterministic_law();
    const auto impacts = impacts_on(slope, law, start_at(slope, 20.0, 50.0, 1.5, {2.6, 0.0, -1.5}));
    ASSERT_GT(impacts.size(), 10U);
    const picus::JumpAngleLaw& angles = law.motion.of<picus::Model>().jump_angle;
    std::size_t jumps = 0;
    for (const GroundImpact& impact : impacts) {
        if (impact.onward != GroundImpact::Onward::jumps) {
            continue;
        }
        ++jumps;
        const double speed_mps = impact.after.whole_mps();
        EXPECT_NEAR(std::atan2(impact.after.normal_mps, impact.after.along_mps),
                    picus::jump_angle(speed_mps * speed_mps, angles).in_radians(), 1e-8);
        EXPECT_LT(speed_mps, impact.before.whole_mps());
        EXPECT_GT(impact.before.normal_mps, 0.0);
    }
    EXPECT_GT(jumps, 10U);
}

TEST(ImpactLog, EachJumpBeginsWhereTheOneBeforeEnded) {
    const Slope slope = plane_slope(35.0, {0.30, 0.75}, 0.01, 600.0);
    for (std::uint64_t rock = 0; rock < 20; ++rock) {
        FallEnd end;
        const auto impacts = impacts_on(slope, FallLaw{},
                                        start_at(slope, 20.0, 50.0, 1.5, {2.6, 0.0, -1.5}, 0.95, rock), &end);
        EXPECT_LE(impacts.size(), end.ground_impacts) << "rolling rocks have impacts too";
        for (std::size_t i = 1; i < impacts.size(); ++i) {
            if (impacts[i - 1].onward == GroundImpact::Onward::jumps) {
                EXPECT_LT((impacts[i].jump.from_m - impacts[i - 1].place_m).norm(), 1e-9);
                EXPECT_NEAR(impacts[i].jump.launch_mps, impacts[i - 1].after.whole_mps(), 1e-9);
            }
        }
        if (!impacts.empty() && impacts.back().onward == GroundImpact::Onward::stops) {
            EXPECT_EQ(impacts.back().after.whole_mps(), 0.0);
        }
    }
}

}  // namespace
}  // namespace rockfall::impact_log_test
