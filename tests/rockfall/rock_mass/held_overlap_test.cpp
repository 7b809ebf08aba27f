#include "rockfall/rock_mass/held_overlap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "rockfall/rock_mass/rock_mass.hpp"
#include "tests/rockfall/rock_mass/scenes.hpp"

namespace rockfall::rock_mass {
namespace {

using Eigen::Vector3d;

/// A cube of 1 m at the origin and one on it, 1 cm in it, shifted and moved; both turned as one.
struct HeldPair {
    solids::Hull lower, upper;
    BlockPose holder, other;

    HeldPair(const Vector3d& moved_m, const Vector3d& turned, const Eigen::Quaterniond& together) {
        const Eigen::Quaterniond turn{Eigen::AngleAxisd{turned.norm(), turned.stableNormalized()}};
        holder = {Vector3d{3.0, 4.0, 5.0}, together};
        other = {holder.centre_m + together * (Vector3d{0.3, 0.1, 0.99} + moved_m), together * turn};
        const solids::Hull cube = solids::box(Vector3d::Ones());
        lower = solids::placed(cube, holder.attitude, holder.centre_m);
        upper = solids::placed(cube, other.attitude, other.centre_m);
    }
    [[nodiscard]] Overlap clipped(OverlapSlope* slope = nullptr) const {
        const std::vector<BlockStart> starts{block_of(lower, 1.0, false), block_of(upper, 1.0, false)};
        const RockMass mass{scenes::lossless(), starts, {}, Ground{}};
        SeparatingFace known;
        return overlap_of(mass.placed(0), mass.placed(1), other.centre_m, known, slope);
    }
};

const Eigen::Quaterniond untouched = Eigen::Quaterniond::Identity();

HeldOverlap held_at_start() {
    const HeldPair pair{Vector3d::Zero(), Vector3d::Zero(), untouched};
    OverlapSlope slope;
    const Overlap overlap = pair.clipped(&slope);
    HeldOverlap held;
    held.keep(overlap, slope, pair.holder, pair.other, 1.0, false);
    return held;
}

TEST(HeldOverlap, IsTheClippedOneToTheSecondOrderOfTheMotion) {
    // Half of the motion has a quarter of the error.
    const Vector3d moved_m{0.008, -0.006, -0.001}, turned{5e-4, -8e-4, 2e-3};
    const auto error_at = [&](double share) {
        HeldOverlap held = held_at_start();
        const HeldPair pair{share * moved_m, share * turned, untouched};
        Overlap carried;
        EXPECT_TRUE(held.carry_on(pair.holder, pair.other, carried));
        const Overlap exact = pair.clipped();
        EXPECT_NEAR((carried.pressure_centre_m() - exact.pressure_centre_m()).norm(), 0.0, 0.06);
        return Eigen::Vector2d{(carried.force_m3 - exact.force_m3).norm() / exact.force_m3.norm(),
                               (carried.moment_m4 - exact.moment_m4).norm() / exact.moment_m4.norm()};
    };
    const Eigen::Vector2d whole = error_at(1.0), half = error_at(0.5);
    // Products of relative changes: sides by 1.1 and 0.7 %, depth by 10 %, and by 5 % where it tilts.
    constexpr double of_second_order = (0.011 + 0.007) * (0.10 + 0.05);
    for (int k = 0; k < 2; ++k) {
        EXPECT_LT(whole[k], of_second_order);
        EXPECT_LT(half[k], 0.3 * whole[k]);
    }
}

TEST(HeldOverlap, TurnsWithBothBodies) {
    const Eigen::Quaterniond together{Eigen::AngleAxisd{2.0, Vector3d{1.0, 2.0, 3.0}.normalized()}};
    const HeldPair there{{0.001, 0.0, 0.001}, {0.0, 1e-4, 0.0}, together};
    const HeldPair here{{0.001, 0.0, 0.001}, {0.0, 1e-4, 0.0}, untouched};
    HeldOverlap held = held_at_start();
    Overlap turned, straight;
    ASSERT_TRUE(held.carry_on(there.holder, there.other, turned));
    ASSERT_TRUE(held.carry_on(here.holder, here.other, straight));
    EXPECT_LT((turned.force_m3 - together * straight.force_m3).norm(), 1e-14);
    EXPECT_LT((turned.moment_m4 - together * straight.moment_m4).norm(), 1e-14);
    EXPECT_LT((turned.pressure_centre_m() - together * straight.pressure_centre_m()).norm(), 1e-12);
}

TEST(HeldOverlap, EndsWhereFacesPartSlideOrTilt) {
    for (const auto& [moved_m, turned] : {std::pair{Vector3d{0.0, 0.0, 0.004}, Vector3d{0.0, 0.0, 0.0}},
                                          {Vector3d{0.06, 0.0, 0.0}, Vector3d{0.0, 0.0, 0.0}},
                                          {Vector3d{0.0, 0.0, 0.0}, Vector3d{0.01, 0.0, 0.0}}}) {
        HeldOverlap held = held_at_start();
        Overlap carried;
        const HeldPair pair{moved_m, turned, untouched};
        EXPECT_FALSE(held.carry_on(pair.holder, pair.other, carried));
        EXPECT_FALSE(held.is_valid());
        EXPECT_FALSE(held.wants_slope());  // it was of no use for a single step
        held.clear();
        EXPECT_TRUE(held.wants_slope());
    }
}

/// A gully with sides of 45 degrees along y, and a cube of 1 m that lies in it on two faces, 1 cm deep in
/// each, shifted across it.
struct CubeInGully {
    static constexpr double depth_m = 0.01;
    std::vector<BlockStart> starts;
    Ground ground;
    BlockPose pose;

    explicit CubeInGully(double across_m) : ground{gully()} {
        pose.centre_m = {across_m, 0.0, std::sqrt(2.0) * (0.5 - depth_m)};
        pose.attitude = Eigen::AngleAxisd{std::numbers::pi / 4.0, Vector3d::UnitY()};
        starts.push_back(block_of(solids::placed(solids::box(Vector3d::Ones()), pose.attitude, pose.centre_m),
                                  1.0, false));
    }
    [[nodiscard]] Overlap clipped(OverlapSlope* slope = nullptr) const {
        const RockMass mass{scenes::lossless(), starts, {}, Ground{}};
        const std::vector<std::uint32_t> prisms = ground.prisms_in({-2.0, -2.0}, {2.0, 2.0});
        return ground.overlap_of(prisms, mass.placed(0), pose.centre_m, slope);
    }
    static Terrain gully() {
        std::vector<Vertex> vertices;
        for (const double y : {-20.0, 20.0}) {
            for (const double x : {-20.0, 0.0, 20.0}) {
                vertices.push_back({x, y, std::abs(x)});
            }
        }
        std::vector<Triangle> triangles(4);
        triangles[0] = {{0, 1, 4}, {no_triangle, 2, 1}};
        triangles[1] = {{0, 4, 3}, {0, no_triangle, no_triangle}};
        triangles[2] = {{1, 5, 4}, {3, no_triangle, 0}};
        triangles[3] = {{1, 2, 5}, {no_triangle, no_triangle, 2}};
        return Terrain{{0.0, 0.0}, std::move(vertices), std::move(triangles)};
    }
};

TEST(HeldOverlap, InAGullyEndsBeforeOneOfItsSidesOpens) {
    const BlockPose ground_pose{Vector3d::Zero(), untouched};
    const CubeInGully start{0.0};
    OverlapSlope slope;
    const Overlap first = start.clipped(&slope);
    ASSERT_FALSE(first.is_none());
    EXPECT_NEAR(first.force_m3.normalized().z(), 1.0, 1e-9);
    // Across the gully by d each side changes by d / sqrt 2: the force turns by d / (sqrt 2 depth), and one
    // side opens at sqrt 2 depth. Neither the way towards the contact nor that along it ends this: the force
    // points upwards, and the sides are 1 m wide.
    const double opens_m = std::sqrt(2.0) * CubeInGully::depth_m;
    const auto carried_to = [&](double across_m, Overlap& carried) {
        HeldOverlap held;
        held.keep(first, slope, ground_pose, start.pose, 1.0, false);
        return held.carry_on(ground_pose, CubeInGully{across_m}.pose, carried);
    };
    ASSERT_LT(opens_m, held_share_of_side);
    Overlap carried;
    ASSERT_TRUE(carried_to(0.95 * held_share_of_depth * opens_m, carried));
    const Overlap exact = CubeInGully{0.95 * held_share_of_depth * opens_m}.clipped();
    EXPECT_GT(std::abs(exact.force_m3.x()), 0.25 * exact.force_m3.norm());  // it has turned
    // What the linear force leaves out: the sides shorten by the way along them, 0.3 % of 1 m, times the
    // change of the pressure.
    EXPECT_LT((carried.force_m3 - exact.force_m3).norm(), 0.01 * exact.force_m3.norm());
    EXPECT_FALSE(carried_to(1.05 * held_share_of_depth * opens_m, carried));
    EXPECT_FALSE(carried_to(1.5 * opens_m, carried));
    EXPECT_FALSE(carried_to(-1.5 * opens_m, carried));
}

}  // namespace
}  // namespace rockfall::rock_mass
