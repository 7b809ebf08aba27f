#include "rockfall/motion/picus/impact_friction.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/rockfall/slopes.hpp"

namespace rockfall::picus::impact_friction_test {
namespace {

using testing::logged_fall;
using testing::plane_slope;
using testing::start_at;

const Eigen::Vector3d level = Eigen::Vector3d::UnitZ();

double share() {
    return *rc::gen::inRange(0, 1'000'001) * 1e-6;
}

TEST(ImpactFriction, TakesCoulombsImpulseFromTheSpeedAlongTheGround) {
    // 0.4 (1 + 0.25) 2 m/s of 10 m/s.
    EXPECT_DOUBLE_EQ(with_friction({0.25, 0.95}, {10.0, 0.0, -2.0}, level, 0.4).tangential, 0.9);
    // The coefficient takes more.
    EXPECT_EQ(with_friction({0.25, 0.85}, {10.0, 0.0, -2.0}, level, 0.4).tangential, 0.85);
    EXPECT_EQ(with_friction({0.25, 0.95}, {10.0, 0.0, -2.0}, level, 0.4).normal, 0.25);
    // Friction stops the slip of a sphere, and no more.
    EXPECT_DOUBLE_EQ(with_friction({0.25, 0.95}, {10.0, 0.0, -8.0}, level, 0.4).tangential, 5.0 / 7.0);
    EXPECT_DOUBLE_EQ(with_friction({0.25, 0.95}, {0.0, 0.0, -8.0}, level, 0.4).tangential, 5.0 / 7.0);
}

RC_GTEST_PROP(ImpactFriction, TakesNoLessThanTheCoefficientAndNoMoreThanWhatStopsTheSlip, ()) {
    const double slope = 1.5 * share();
    const Eigen::Vector3d normal{std::sin(slope), 0.0, std::cos(slope)};
    const Eigen::Vector3d along{std::cos(slope), 0.0, -std::sin(slope)};
    const double into_mps = 40.0 * share();
    const double along_mps = 40.0 * share();
    const double friction = share();
    const Restitution usual{0.6 * share(), share()};
    const Restitution found = with_friction(usual, along_mps * along - into_mps * normal, normal, friction);
    RC_ASSERT(found.normal == usual.normal);
    RC_ASSERT(found.tangential <= usual.tangential);
    RC_ASSERT(found.tangential >= std::min(usual.tangential, 1.0 - largest_friction_share) - 1e-12);
    const double impulse_mps = friction * (1.0 + usual.normal) * into_mps;
    const double taken_mps = (1.0 - found.tangential) * along_mps;
    RC_ASSERT(taken_mps >= std::min(impulse_mps, largest_friction_share * along_mps) - 1e-9);
    // More friction never takes less.
    RC_ASSERT(
        with_friction(usual, along_mps * along - into_mps * normal, normal, friction + 0.1).tangential <=
        found.tangential + 1e-12);
}

/// Rocks of 200 that pass 400 m of an even meadow.
int passing(double slope_deg, bool friction) {
    const Slope slope = plane_slope(slope_deg, {0.35, 0.95}, 0.0, 600.0, 600.0);
    FallLaw law;
    law.motion.of<Model>().impact_friction = friction;
    law.motion.of<Model>().rolling.friction = 0.35;
    int passed = 0;
    for (std::uint64_t id = 0; id < 200; ++id) {
        const auto [end, log] =
            logged_fall(slope, law, start_at(slope, 50.0, 300.0, 1.5, {20.0, 0.0, -5.0}, 1.0, id));
        passed += end.position_m.x() + slope.terrain.origin_m().x() > 450.0 ? 1 : 0;
    }
    return passed;
}

TEST(ImpactFriction, LetsNoRockHopOnWhereNoneWouldRoll) {
    // tan 12 degrees is 0.21, below two thirds of the friction: what a hop gains is less than it costs.
    EXPECT_EQ(passing(12.0, true), 0);
    EXPECT_GT(passing(12.0, false), 20) << "r_t alone lets them go on";
    EXPECT_GT(passing(30.0, true), 100) << "steep ground is as before";
}

}  // namespace
}  // namespace rockfall::picus::impact_friction_test
