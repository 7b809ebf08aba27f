#include "rockfall/obstacles/tree_impact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rockfall/obstacles/tree_energy.hpp"
#include "tests/rockfall/slopes.hpp"

namespace rockfall::tree_impact_test {
namespace {

PlacedStem fir(double dbh_cm) {
    return {0.0, 0.0, 0.0, 25.0, 25.0, 0.005 * dbh_cm, largest_energy_j(dbh_cm, 1.0)};
}

StemHit hit_at(double relative_position, double height_m = 1.0) {
    constexpr double reach_m = 0.7;
    return {0, 0.0, relative_position * reach_m, reach_m, height_m};
}

TreeImpactLaw law() {
    return testing::deterministic_law().tree;
}

TEST(MeetStem, StopsARockThatTheTreeCanHold) {
    const TreeImpact impact = meet_stem(100e3, hit_at(0.0), fir(40.0), law(), {0.5, 0.5, 0.5, 0.5});
    EXPECT_TRUE(impact.stopped);
    EXPECT_FALSE(impact.broken);
    EXPECT_DOUBLE_EQ(impact.loss_j, 100e3);
}

TEST(MeetStem, BreaksUnderAFrontalHitBeyondItsStrength) {
    const TreeImpact frontal = meet_stem(400e3, hit_at(0.1), fir(40.0), law(), {0.5, 0.5, 0.5, 0.5});
    EXPECT_TRUE(frontal.broken);
    EXPECT_NEAR(frontal.loss_j, 0.98 * 194.3e3, 0.01 * 194.3e3);
    EXPECT_NEAR(frontal.speed_factor, std::sqrt(1.0 - frontal.loss_j / 400e3), 1e-12);
    EXPECT_FALSE(meet_stem(400e3, hit_at(0.6), fir(40.0), law(), {0.5, 0.5, 0.5, 0.5}).broken);
}

TEST(MeetStem, ScratchesWithoutLoss) {
    const TreeImpact impact = meet_stem(100e3, hit_at(0.9), fir(40.0), law(), {0.99, 0.99, 0.5, 0.5});
    EXPECT_EQ(impact.type, HitType::scratch);
    EXPECT_EQ(impact.loss_j, 0.0);
    // 2 % of the stem's strength limits the turn: sin^2 = 0.02 * 194.3 / 100.
    EXPECT_NEAR(std::abs(impact.turn.sin), std::sqrt(0.02 * 1.943), 1e-3);
}

TEST(MeetStem, TurnsAwayFromTheAxis) {
    EXPECT_LT(meet_stem(150e3, hit_at(0.5), fir(30.0), law(), {0.3, 0.5, 0.5, 0.5}).turn.sin,
              0.0);  // axis left: to the right
    EXPECT_GT(meet_stem(150e3, hit_at(-0.5), fir(30.0), law(), {0.3, 0.5, 0.5, 0.5}).turn.sin, 0.0);
}

TEST(MeetStem, DrawsTheClassesOfTheMatrix) {
    const double energy_j = 60e3;  // below the available energy at 0.5: the turn is not limited
    constexpr int draws = 200'000;
    int below = 0;
    int above = 0;
    for (int i = 0; i < draws; ++i) {
        const config::RandomStream stream{{7, 0, 0, static_cast<std::uint64_t>(i)}, config::Purpose::test};
        const TreeImpact impact = meet_stem(energy_j, hit_at(0.45), fir(60.0), law(), stream.uniforms_of(0));
        const double turn_deg =
            std::abs(std::atan2(impact.turn.sin, impact.turn.cos)) * 180.0 / std::numbers::pi;
        below += turn_deg < 22.5 ? 1 : 0;
        above += turn_deg > 67.5 ? 1 : 0;
    }
    const auto four_sigma = [&](double p) { return 4.0 * std::sqrt(p * (1.0 - p) / draws); };
    EXPECT_NEAR(static_cast<double>(below) / draws, 0.19, four_sigma(0.19));
    EXPECT_NEAR(static_cast<double>(above) / draws, 0.05, four_sigma(0.05));
}

TEST(MeetStem, HasLessStrengthHigherUp) {
    TreeImpactLaw with_height = law();
    with_height.height_effect = true;
    const TreeImpact low = meet_stem(1e6, hit_at(0.0, 1.0), fir(40.0), with_height, {0.5, 0.5, 0.5, 0.5});
    const TreeImpact high = meet_stem(1e6, hit_at(0.0, 8.0), fir(40.0), with_height, {0.5, 0.5, 0.5, 0.5});
    EXPECT_DOUBLE_EQ(low.loss_j,
                     meet_stem(1e6, hit_at(0.0, 1.0), fir(40.0), law(), {0.5, 0.5, 0.5, 0.5}).loss_j);
    EXPECT_NEAR(high.loss_j / low.loss_j, std::pow((25.0 - 8.0) / (25.0 - 1.3), 0.8 * 2.31), 1e-9);
}

}  // namespace
}  // namespace rockfall::tree_impact_test
