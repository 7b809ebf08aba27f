// Blocks on an even plane against closed forms: the table that decided for an engine of our own.

#include <gtest/gtest.h>

#include <numbers>

#include "tests/rockfall/motion/rigid/scene.hpp"

namespace rockfall::rigid {
namespace {

using namespace testing;
using config::gravity_mps2;

constexpr double hillside_deg = 38.0;
constexpr double moving_s = 10.0;
const double half_square_s2 = 0.5 * moving_s * moving_s;

double down_mps2(double share_of_sine, double friction) {
    return gravity_mps2 *
           (share_of_sine * std::sin(radians(hillside_deg)) - friction * std::cos(radians(hillside_deg)));
}

TEST(RigidBlockOnAPlane, SphereRollsWithFiveSeventhsOfGravity) {
    const Slope slope = plane(hillside_deg, 400.0);
    const solids::Solid ball = solids::ball_of(0.5, 2700.0);
    const double exact_m = half_square_s2 * down_mps2(5.0 / 7.0, 0.0);
    EXPECT_NEAR(exact_m, 215.701, 1e-3);
    EXPECT_NEAR(way_m(slope, law_of(0.7, 0.0), ball, lying(slope, ball, hillside_deg, 20.0, 10.0), moving_s),
                exact_m, 1e-4 * exact_m);
}

TEST(RigidBlockOnAPlane, SphereSlipsBelowTwoSeventhsOfTheTangent) {
    const Slope slope = plane(hillside_deg, 400.0);
    const solids::Solid ball = solids::ball_of(0.5, 2700.0);
    const Body start = lying(slope, ball, hillside_deg, 20.0, 10.0);
    EXPECT_NEAR(way_m(slope, law_of(0.1, 0.0), ball, start, moving_s), 263.330, 0.026);

    const double threshold = 2.0 / 7.0 * std::tan(radians(hillside_deg));
    for (const double friction : {0.999 * threshold, 1.001 * threshold}) {
        const double exact_m = half_square_s2 * std::max(down_mps2(1.0, friction), down_mps2(5.0 / 7.0, 0.0));
        EXPECT_NEAR(way_m(slope, law_of(friction, 0.0), ball, start, moving_s), exact_m, 1e-4 * exact_m)
            << friction;
    }
}

TEST(RigidBlockOnAPlane, CubeSlidesAndSticksByCoulomb) {
    const Slope slope = plane(hillside_deg, 400.0);
    const solids::Solid block = cube();
    const Body start = lying(slope, block, hillside_deg, 20.0, 10.0);
    for (const double friction : {0.35, 0.70}) {
        const double exact_m = half_square_s2 * down_mps2(1.0, friction);
        EXPECT_NEAR(way_m(slope, law_of(friction, 0.0), block, start, moving_s), exact_m, 1e-4 * exact_m)
            << friction;
    }
    EXPECT_LT(way_m(slope, law_of(0.85, 0.0), block, start, 60.0), 1e-3);
}

TEST(RigidBlockOnAPlane, BoxTipsWhereItsWeightLineLeavesItsBase) {
    // Half as long as high: tips from atan(1/2) = 26.565 deg on, if friction is larger than that.
    const solids::Solid tower = solids::solid_of(solids::box({0.5, 0.5, 1.0}), 2700.0);
    const double limit_deg = config::Angle::from_radians(std::atan(0.5)).in_degrees();
    for (const double beyond_deg : {-0.1, 0.1}) {
        const double deg = limit_deg + beyond_deg;
        const Slope slope = plane(deg, 100.0);
        BlockScratch scratch;
        const Body start = lying(slope, tower, deg, 20.0, 10.0);
        const Law law = law_of(0.9, 0.0);
        Block block{slope, law, tower, start, slope.terrain.locate(20.0, 10.0).value(), scratch};
        const Body end = moved(block, law, 6.0, true);
        const bool tipped = (end.rotation.attitude * Vector3d::UnitX())
                                .cross(start.rotation.attitude * Vector3d::UnitX())
                                .norm() > 0.1;
        EXPECT_EQ(tipped, beyond_deg > 0.0) << deg;
    }
}

TEST(RigidBlockOnAPlane, KeepsTheEdgeAboutWhichItTurnsAtTheGround) {
    // A cube that tips over from 3 degrees beyond its edge: (2/3) a^2 w^2 / 2 = g a / sqrt(2) (cos t0 - cos
    // t). Without a hold it lost the contact for single steps, and the slip decayed there.
    const Slope flat = plane(0.0, 100.0);
    constexpr double side_m = 0.5;
    const solids::Solid block = cube(side_m);
    constexpr double beyond_deg = 3.0;
    const Eigen::Quaterniond turned{Eigen::AngleAxisd{radians(45.0 + beyond_deg), Vector3d::UnitY()}};
    for (const double step_s : {0.5e-3, 1e-3, 2e-3}) {
        Law law = law_of(1.5, 0.0);
        law.friction_law = FrictionLaw::slip;
        law.friction_max = 2.0;
        law.slip_beta_ps = 185.0;
        law.slip_kappa_pm = 3.0;
        law.step_s = step_s;
        const Body start = lying(flat, block, 0.0, 20.0, 10.0, turned);
        BlockScratch scratch;
        Block tipping{flat, law, block, start, flat.terrain.locate(20.0, 10.0).value(), scratch};
        double way_m = 0.0;
        double tilt_rad = radians(beyond_deg);
        while (tilt_rad < radians(35.0)) {
            const Vector3d before_m = tipping.body().centre_m;
            bool inside = true;
            const Touchdown touchdown = tipping.step(step_s, inside);
            ASSERT_TRUE(touchdown.touched && touchdown.lasts) << step_s << " s, " << tilt_rad;
            way_m += (tipping.body().centre_m - before_m).norm();
            tilt_rad = radians(beyond_deg) +
                       start.rotation.attitude.angularDistance(tipping.body().rotation.attitude);
        }
        const double exact_radps = std::sqrt(3.0 * gravity_mps2 / (std::numbers::sqrt2 * side_m) *
                                             (std::cos(radians(beyond_deg)) - std::cos(tilt_rad)));
        EXPECT_NEAR(tipping.body().spin_radps(block).norm(), exact_radps, 2e-3 * exact_radps) << step_s;
        EXPECT_NEAR(tipping.slip_m(), way_m, 2e-3 * way_m) << step_s;
        EXPECT_NEAR(tipping.gap_m(0.1), 0.0, gravity_mps2 * step_s * step_s) << step_s;
    }
}

TEST(RigidBlockOnAPlane, SlidingSphereEndsRollingAtFiveSeventhsOfItsSpeed) {
    const Slope flat = plane(0.0, 100.0);
    const solids::Solid ball = solids::ball_of(0.5, 2700.0);
    Body start = lying(flat, ball, 0.0, 20.0, 10.0);
    start.velocity_mps = {7.0, 0.0, 0.0};
    BlockScratch scratch;
    const Law law = law_of(0.4, 0.0);
    Block block{flat, law, ball, start, flat.terrain.locate(20.0, 10.0).value(), scratch};
    EXPECT_NEAR(moved(block, law, 5.0, true).velocity_mps.x(), 5.0, 5e-4);
}

TEST(RigidBlockOnAPlane, RollingResistanceSlowsAsACoupleDoes) {
    // a = 5/7 g (sin - mu_r cos), and no motion above the threshold tan < mu_r.
    const Slope slope = plane(hillside_deg, 400.0);
    const solids::Solid ball = solids::ball_of(0.5, 2700.0);
    Law law = law_of(0.9, 0.0);
    law.rolling_resistance = 0.2;
    const Body start = lying(slope, ball, hillside_deg, 20.0, 10.0);
    const double exact_m = half_square_s2 * 5.0 / 7.0 * gravity_mps2 *
                           (std::sin(radians(hillside_deg)) - 0.2 * std::cos(radians(hillside_deg)));
    EXPECT_NEAR(way_m(slope, law, ball, start, moving_s), exact_m, 1e-4 * exact_m);
    law.rolling_resistance = 0.8;
    EXPECT_LT(way_m(slope, law, ball, start, 10.0), 1e-3);
}

TEST(RigidBlockOnAPlane, SlipLawLiftsTheRearCornerOfThePyramid) {
    // At rest on 45 deg on two corners of its base: friction reaches tan 45 = b/h at s = tan(pi/2
    // (1-0.2)/1.1)/0.7.
    const Slope slope = plane(45.0, 200.0);
    const solids::Solid pyramid =
        solids::solid_of(solids::double_pyramid({2.0, 2.0, 20.0}), 80'000.0 / (4.0 * 20.0 / 3.0));
    EXPECT_NEAR(pyramid.mass_kg, 80'000.0, 1.0);
    Law law = law_of(0.2, 0.0);
    law.friction_law = FrictionLaw::slip;
    law.friction_max = 1.3;
    law.slip_kappa_pm = 0.7;
    law.slip_beta_ps = 150.0;
    // Its long axis lies across the slope.
    const Eigen::Quaterniond across{Eigen::AngleAxisd{radians(90.0), Vector3d::UnitX()}};
    const Body start = lying(slope, pyramid, 45.0, 20.0, 10.0, across);
    const double exact_m = std::tan(0.5 * std::numbers::pi * (1.0 - 0.2) / (1.3 - 0.2)) / 0.7;
    EXPECT_NEAR(exact_m, 3.128, 5e-4);
    for (const double step_s : {0.5e-3, 1e-3}) {
        law.step_s = step_s;
        BlockScratch scratch;
        Block block{slope, law, pyramid, start, slope.terrain.locate(20.0, 10.0).value(), scratch};
        bool inside = true;
        // Percussions act in the middle of steps: the corner lifts between the last that did not turn the
        // block and the first that does, so where the latter's step begins.
        Body before = block.body();
        while (inside && block.slip_m() < 4.0 && block.body().spin_radps(pyramid).norm() < 1e-8) {
            before = block.body();
            block.step(law.step_s, inside);
        }
        EXPECT_NEAR((before.centre_m - start.centre_m).norm(), exact_m, 1e-3 * exact_m) << step_s;
        EXPECT_NEAR(before.velocity_mps.norm(), 3.492, 1e-3 * 3.492) << step_s;
        // The rear corner is the one that lifts: the block turns about its lower edge.
        EXPECT_GT(block.body().spin_radps(pyramid).y(), 0.0) << step_s;
    }
}

TEST(RigidBlockOnAPlane, DropReboundsByTheSquareOfRestitution) {
    const Slope flat = plane(0.0, 100.0);
    const std::vector<Eigen::Quaterniond> faces{Eigen::Quaterniond::Identity()};
    for (const double e : {0.1, 0.3, 0.5, 0.8, 1.0}) {
        for (const bool round : {true, false}) {
            const solids::Solid solid = round ? solids::ball_of(0.5, 2700.0) : cube();
            Body start = lying(flat, solid, 0.0, 50.3, 10.2);
            start.centre_m.z() += 1.0;
            BlockScratch scratch;
            const Law law = law_of(0.5, e);
            Block block{flat, law, solid, start, flat.terrain.locate(50.3, 10.2).value(), scratch};
            const FreeFlight flight = block.fly();
            EXPECT_NEAR(flight.duration_s, std::sqrt(2.0 / gravity_mps2), 1e-9);
            block.go_on(flight.duration_s);
            block.strike();
            const double up_mps = block.body().velocity_mps.z();
            EXPECT_NEAR(up_mps * up_mps / (2.0 * gravity_mps2), e * e, 1e-3 * e * e) << e << " " << round;
        }
    }
}

TEST(RigidBlockOnAPlane, DropOnACornerFollowsTheFormulaOfOnePoint) {
    // A corner that sticks: P = -(1 + e) v_n / G_nn with friction; for a vertical drop on frictionless ground
    // v+ = v (1 - (1 + e) (1/m) / (1/m + (r x n) I^-1 (r x n))).
    const Slope flat = plane(0.0, 100.0);
    const solids::Solid block = cube();
    for (const double e : {0.0, 0.5, 1.0}) {
        for (const Eigen::Quaterniond& turned :
             {Eigen::Quaterniond{Eigen::AngleAxisd{0.4, Vector3d{1.0, 0.3, 0.0}.normalized()}},
              Eigen::Quaterniond{Eigen::AngleAxisd{0.5, Vector3d::UnitX()}}}) {
            Body start = lying(flat, block, 0.0, 50.3, 10.2, turned);
            start.centre_m.z() += 1.0;
            BlockScratch scratch;
            const Law law = law_of(0.0, e);
            Block falling{flat, law, block, start, flat.terrain.locate(50.3, 10.2).value(), scratch};
            falling.go_on(falling.fly().duration_s);
            const double v = falling.body().velocity_mps.z();
            Vector3d arm_m = Vector3d::Zero();
            int lowest = 0;
            for (const Vector3d& vertex_m : block.hull.vertices_m) {
                const Vector3d at_m = falling.body().rotation.attitude * vertex_m;
                if (at_m.z() < arm_m.z() - 1e-6) {
                    arm_m = at_m;
                    lowest = 1;
                } else if (at_m.z() < arm_m.z() + 1e-6) {
                    arm_m += at_m;  // an edge: its middle
                    ++lowest;
                }
            }
            arm_m /= lowest;
            const Vector3d turn = arm_m.cross(Vector3d::UnitZ());
            const double inertia = block.inertia_kgm2.x();
            const double share = (1.0 / block.mass_kg) / (1.0 / block.mass_kg + turn.squaredNorm() / inertia);
            falling.strike();
            EXPECT_NEAR(falling.body().velocity_mps.z(), v * (1.0 - (1.0 + e) * share), 1e-3 * std::abs(v))
                << e;
        }
    }
}

}  // namespace
}  // namespace rockfall::rigid
