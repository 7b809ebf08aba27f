#include "rockfall/laws/groove.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "rockfall/slope/profile_strip.hpp"
#include "tests/rockfall/slopes.hpp"
#include "tests/rockfall/terrain/profiles.hpp"

namespace rockfall::groove_test {
namespace {

/// A gully that falls by 4 in 5 along x, its walls rising by 1 in 2 to either side.
const Eigen::Vector3d left_wall = Eigen::Vector3d{0.8, -0.5, 1.0}.normalized();
const Eigen::Vector3d right_wall = Eigen::Vector3d{0.8, 0.5, 1.0}.normalized();
const Eigen::Vector3d downhill = Eigen::Vector3d{1.0, 0.0, -0.8}.normalized();

TEST(AlongEdge, KeepsWhatLiesAlongTheFloorOfAGully) {
    // Straight into one wall, and up and down: only the part along the floor is left, with its sign.
    const Eigen::Vector3d across = downhill.cross(Eigen::Vector3d{Eigen::Vector3d::UnitY()});
    for (const double along_mps : {6.0, 0.0, -2.0}) {
        const Eigen::Vector3d velocity_mps =
            along_mps * downhill + 3.0 * Eigen::Vector3d::UnitY() - 1.5 * across;
        for (const Eigen::Vector3d& kept_mps : {along_edge(velocity_mps, left_wall, right_wall),
                                                along_edge(velocity_mps, right_wall, left_wall)}) {
            EXPECT_LT((kept_mps - along_mps * downhill).norm(), 1e-12) << along_mps;
        }
    }
}

TEST(AlongEdge, LiesInBothFacesAndGainsNoSpeed) {
    const Eigen::Vector3d steep = Eigen::Vector3d{0.3, 2.0, 0.4}.normalized();
    const Eigen::Vector3d velocity_mps{4.0, -7.0, -3.0};
    const Eigen::Vector3d kept_mps = along_edge(velocity_mps, left_wall, steep);
    EXPECT_NEAR(kept_mps.dot(left_wall), 0.0, 1e-12);
    EXPECT_NEAR(kept_mps.dot(steep), 0.0, 1e-12);
    EXPECT_GT(kept_mps.dot(velocity_mps), 0.0);
    EXPECT_LT(kept_mps.norm(), velocity_mps.norm());
}

TEST(AlongEdge, IsTheWayInTheFaceWhereThereIsNoEdge) {
    const Eigen::Vector3d velocity_mps{4.0, -7.0, -3.0};
    const Eigen::Vector3d kept_mps = along_edge(velocity_mps, left_wall, left_wall);
    EXPECT_LT((kept_mps - (velocity_mps - velocity_mps.dot(left_wall) * left_wall)).norm(), 1e-12);
}

TEST(StrikesInTurn, AreTwoAtMostUntilTheRockGetsSomewhere) {
    StrikesInTurn strikes;
    for (int twice = 0; twice < 2; ++twice) {
        EXPECT_FALSE(strikes.once_more(0.0));
        EXPECT_FALSE(strikes.once_more(3e-17));
        EXPECT_TRUE(strikes.once_more(0.0));
        EXPECT_TRUE(strikes.once_more(0.0));
        EXPECT_FALSE(strikes.once_more(0.02));
    }
}

TEST(Fall, SlidesOnInAGullyWhoseWallsItStrikesInTurn) {
    // Turned by 20 degrees at most they would strike the walls up to five times in turn in no time.
    const config::GridFrame frame{60, 20, 0.0, 0.0, 5.0, 5.0};
    const Slope gully = testing::slope_over(
        testing::heights_of(frame,
                            [](double x, double y) { return 400.0 - 0.8 * x + 0.5 * std::abs(y - 47.5); }),
        {0.35, 0.85});
    FallLaw law = testing::deterministic_law();
    law.motion.model = motion_model<classical::Model>;
    law.motion.of<classical::Model>().lateral = config::Angle::from_degrees(20.0);
    for (std::uint64_t rock = 0; rock < 200; ++rock) {
        const auto [end, log] = testing::logged_fall(
            gully, law, testing::start_at(gully, 20.0, 60.0, 1.0, {1.0, -1.0, 0.0}, 0.8, rock));
        EXPECT_EQ(end.reason, StopReason::left_terrain) << rock;
        int in_a_row = 0;
        int most_in_a_row = 0;
        for (const testing::EventLog::Jump& jump : log.jumps) {
            in_a_row = jump.until_s < 1e-9 ? in_a_row + 1 : 0;
            most_in_a_row = std::max(most_in_a_row, in_a_row);
        }
        EXPECT_LT(most_in_a_row, 3) << rock;
    }
}

/// A straight gully over triangles whose edges follow its floor: two walls that rise to either side of y = 0.
/// Triangle 0 is the wall at y > 0, triangle 1 the one at y < 0.
Terrain gully_of_two_faces(double fall, double wall) {
    std::vector<Vertex> vertices{{0.0, 0.0, 0.0},
                                 {100.0, 0.0, -100.0 * fall},
                                 {50.0, 50.0, -50.0 * fall + 50.0 * wall},
                                 {50.0, -50.0, -50.0 * fall + 50.0 * wall}};
    std::vector<Triangle> triangles{{{0, 1, 2}, {1, no_triangle, no_triangle}},
                                    {{1, 0, 3}, {0, no_triangle, no_triangle}}};
    return Terrain{{0.0, 0.0}, std::move(vertices), std::move(triangles)};
}

constexpr double g = 9.81;

TEST(RunIfPressed, IsTheLimitOfGoingToAndFro) {
    constexpr double fall = 0.8, wall = 0.9, friction = 0.5;
    const Terrain terrain = gully_of_two_faces(fall, wall);
    const Eigen::Vector3d floor = Eigen::Vector3d{1.0, 0.0, -fall}.normalized();
    const Eigen::Vector3d start{10.0, 0.0, -10.0 * fall};
    const auto run = run_if_pressed(terrain, 0, 1, start, 4.0 * floor, {friction, 1.0, true});
    ASSERT_TRUE(run);
    EXPECT_EQ(run->end, RollingEnd::edge);
    EXPECT_LT((run->velocity_mps - 4.0 * floor).norm(), 1e-12);
    EXPECT_LT((run->position_m(run->duration_s) - Eigen::Vector3d{100.0, 0.0, -100.0 * fall}).norm(), 1e-9);
    // Both walls are alike: friction is that of either.
    const double support = 1.0 / std::sqrt(1.0 + fall * fall + wall * wall);
    const double length_m = 90.0 * std::sqrt(1.0 + fall * fall);
    const double squared_end = 16.0 + 2.0 * g * (90.0 * fall - friction * support * length_m);
    EXPECT_NEAR(run->velocity_at(run->duration_s).squaredNorm(), squared_end, 1e-9);
}

TEST(RunIfPressed, TurnsNoSpeedAcrossALevelEdgeIntoOneAlongIt) {
    // Walls of 80 degrees: what falls down one of them has hardly any speed in plan.
    const Terrain crack = gully_of_two_faces(0.0, 5.67);
    const Eigen::Vector3d down_the_wall = 0.02 * Eigen::Vector3d{0.0, 1.0, 5.67}.normalized();
    const auto run = run_if_pressed(crack, 1, 0, {60.0, 0.0, 0.0}, down_the_wall, {0.5, 1.0, true});
    ASSERT_TRUE(run);
    EXPECT_EQ(run->end, RollingEnd::standstill);
    EXPECT_EQ(run->duration_s, 0.0);
    EXPECT_EQ(run->velocity_mps, Eigen::Vector3d::Zero());
    // Of what comes askew only the part along the edge goes on.
    const auto askew = run_if_pressed(crack, 1, 0, {60.0, 0.0, 0.0},
                                      down_the_wall + Eigen::Vector3d{0.03, 0.0, 0.0}, {0.5, 1.0, true});
    ASSERT_TRUE(askew);
    EXPECT_LT((askew->velocity_mps - Eigen::Vector3d{0.03, 0.0, 0.0}).norm(), 1e-12);
}

/// A level crack of 2 cm across the strip, 6 m deep below the upper and 2 m below the lower side.
const std::vector<ProfilePoint> crack_profile{
    {0.0, 20.0, 0}, {20.0, 16.0, 0}, {20.01, 10.0, 0}, {20.02, 12.0, 0}, {40.0, 8.0, 0}};

/// Whether a rock in the crack, anywhere on its walls, is led along it.
bool leads_along_crack(const Terrain& terrain, double friction) {
    bool leads = false;
    for (const double x_m : {20.002, 20.008, 20.01, 20.014}) {
        const auto triangle = terrain.locate(x_m, 0.0);
        const Eigen::Vector3d place{x_m, 0.0, terrain.plane_of(triangle.value()).height_m(x_m, 0.0)};
        leads = leads || run_along_groove(terrain, *triangle, place, 0.5, {friction});
    }
    return leads;
}

TEST(RunAlongGroove, IsNoneInACrackWhoseFloorIsFlatterThanFriction) {
    const Terrain level = strip_slope(crack_profile, {testing::ground({0.3, 0.8})}).terrain;
    EXPECT_FALSE(leads_along_crack(level, 0.3));
    for (const double dip : {5e-6, 1e-3, 0.27, 0.33}) {
        std::vector<Vertex> vertices{level.vertices().begin(), level.vertices().end()};
        for (Vertex& vertex : vertices) {
            vertex.z_m -= dip * vertex.y_m;
        }
        const Terrain tilted{
            {0.0, 0.0}, std::move(vertices), {level.triangles().begin(), level.triangles().end()}};
        EXPECT_EQ(leads_along_crack(tilted, 0.3), dip > 0.3) << dip;
    }
}

TEST(RunAlongGroove, IsNoneInALevelCrackOverAGrid) {
    // Cells of one rock diameter: nearly every place is near a vertex, here of the floor at x = 30.5.
    const config::GridFrame frame{60, 40, 0.0, 0.0, 1.0, 1.0};
    const Slope slope = testing::slope_over(
        testing::heights_of(
            frame, [](double x, double) { return std::abs(x - 30.5) < 0.1 ? 83.0 : 100.0 - 0.4 * x; }),
        {0.35, 0.85});
    for (int i = 0; i < 400; ++i) {
        const double x_m = 30.05 + 0.00225 * i;
        const double y_m = 15.0 + 0.0237 * i;
        const auto triangle = slope.terrain.locate(x_m, y_m);
        ASSERT_TRUE(triangle);
        const double z_m = slope.terrain.plane_of(*triangle).height_m(x_m, y_m);
        EXPECT_FALSE(run_along_groove(slope.terrain, *triangle, {x_m, y_m, z_m}, 0.5, {0.5})) << x_m;
    }
}

TEST(RunIfPressed, KeepsItsSpeedOnTheWayUpAndStops) {
    const Terrain terrain = gully_of_two_faces(0.8, 0.9);
    const Eigen::Vector3d uphill = Eigen::Vector3d{-1.0, 0.0, 0.8}.normalized();
    const auto run = run_if_pressed(terrain, 1, 0, {60.0, 0.0, -48.0}, 5.0 * uphill, {0.5, 1.0, true});
    ASSERT_TRUE(run);
    EXPECT_EQ(run->end, RollingEnd::standstill);
    EXPECT_GT(run->duration_s, 0.0);
    EXPECT_LT(run->velocity_at(run->duration_s).norm(), 1e-12);
    EXPECT_GT(run->position_m(run->duration_s).z(), -48.0);
}

TEST(RunIfPressed, SetsOffWhereGravityExceedsFriction) {
    const Eigen::Vector3d place{60.0, 0.0, -48.0};
    const auto steep =
        run_if_pressed(gully_of_two_faces(0.8, 0.9), 1, 0, place, Eigen::Vector3d::Zero(), {0.5, 1.0, true});
    ASSERT_TRUE(steep);
    EXPECT_EQ(steep->end, RollingEnd::edge);
    EXPECT_LT(steep->position_m(steep->duration_s).z(), -79.0);
    const auto flat = run_if_pressed(gully_of_two_faces(0.1, 0.9), 1, 0, {60.0, 0.0, -6.0},
                                     Eigen::Vector3d::Zero(), {0.5, 1.0, true});
    ASSERT_TRUE(flat);
    EXPECT_EQ(flat->end, RollingEnd::standstill);
    EXPECT_EQ(flat->duration_s, 0.0);
}

TEST(RunIfPressed, IsNoneWhereAFaceLetsTheRockGoOrItGoesFar) {
    const Terrain gully = gully_of_two_faces(0.8, 0.9);
    const Terrain ridge = gully_of_two_faces(0.8, -0.9);
    const Eigen::Vector3d start{10.0, 0.0, -8.0};
    const Eigen::Vector3d along{3.0, 0.0, -2.4};
    EXPECT_FALSE(run_if_pressed(ridge, 0, 1, start, along, {0.5, 1.0, true}));
    // Fast into the wall: it climbs for longer than a moment.
    EXPECT_FALSE(
        run_if_pressed(gully, 0, 1, start, along + Eigen::Vector3d{0.0, -2.0, 1.8}, {0.5, 1.0, true}));
    // Of no common edge there is nothing to tell.
    EXPECT_FALSE(run_if_pressed(gully, 7, 1, start, along, {0.5, 1.0, true}));
}

/// Speed at the end of a steep gully of the model's own mesh, entered beside its floor.
double speed_below_gully_mps(double wall, MotionModel model) {
    const double fall = std::tan(40.0 * M_PI / 180.0);
    const config::GridFrame frame{41, 21, 0.0, 0.0, 10.0, 10.0};
    const Slope gully = testing::slope_over(
        testing::heights_of(
            frame, [&](double x, double y) { return 500.0 - fall * x + wall * std::abs(y - 105.0); }),
        {0.35, 0.85});
    FallLaw law = testing::sliding_law();
    law.motion.model = model;
    law.motion.of<classical::Model>().lateral = config::Angle{};
    law.motion.of<classical::Model>().restitution_deviation = 0.0;
    const RockStart start =
        testing::start_at(gully, 15.0, 105.5, 0.0, 8.0 * Eigen::Vector3d{1.0, 0.0, -fall}.normalized());
    const auto [end, log] = testing::logged_fall(gully, law, start);
    EXPECT_EQ(end.reason, StopReason::left_terrain) << wall;
    EXPECT_LT(log.rolls.size(), 5000U) << wall;
    double last_mps = 0.0;
    for (const testing::EventLog::Roll& roll : log.rolls) {
        last_mps = roll.piece.velocity_at(roll.piece.duration_s).norm();
    }
    return last_mps;
}

/// Whether the walls meet more or less steeply than the faces that rocks run over a little (gradients that
/// differ by 3) must not show.
TEST(Fall, SlidesThroughSteepGulliesWithoutAStop) {
    for (const MotionModel model : {motion_model<pir3d::Model>, motion_model<classical::Model>}) {
        const double gentle_mps = speed_below_gully_mps(1.45, model);
        const double steep_mps = speed_below_gully_mps(1.55, model);
        EXPECT_GT(gentle_mps, 30.0);
        EXPECT_NEAR(steep_mps, gentle_mps, 0.05 * gentle_mps);
    }
}

}  // namespace
}  // namespace rockfall::groove_test
