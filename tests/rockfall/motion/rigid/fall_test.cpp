// Whole falls of rigid blocks: starts, what stands in their way, and where their energy goes.

#include "rockfall/motion/rigid/fall.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>

#include "config/random/distributions.hpp"
#include "rockfall/tally/footprint.hpp"
#include "tests/rockfall/motion/rigid/scene.hpp"

namespace rockfall::rigid::testing {
namespace {

using Eigen::Quaterniond;
using rockfall::testing::EventLog;
using rockfall::testing::heights_of;
using rockfall::testing::logged_fall;
using rockfall::testing::plane_slope;
using rockfall::testing::slope_over;
using rockfall::testing::start_at;

FallLaw rigid_law() {
    FallLaw law = rockfall::testing::deterministic_law();
    law.motion.model = motion_model<rigid::Model>;
    return law;
}

/// A rock with a shape at a place; its attitude as given.
RockStart block_at(const Slope& slope, const Vector3d& sides_m, double x_m, double y_m, double height_m,
                   const Vector3d& velocity_mps, const Quaterniond& attitude = Quaterniond::Identity(),
                   std::uint64_t id = 0) {
    const auto solid = std::make_shared<const solids::Solid>(solids::solid_of(solids::box(sides_m), 2700.0));
    RockStart start = start_at(slope, x_m, y_m, height_m, velocity_mps, solid->diameter_m(), id);
    start.block = {solid, attitude};
    start.heading = Eigen::Vector2d::UnitX();
    return start;
}

BlockStart begin_of(const Slope& slope, const Law& law, const RockStart& start) {
    BlockScratch scratch;
    return start_of_block(slope, law, start, *start.block.solid, scratch);
}

double gap_m(const Slope& slope, const Law& law, const RockStart& start, const BlockStart& begin) {
    BlockScratch scratch;
    Block block{slope, law, *start.block.solid, begin.body, begin.triangle, scratch};
    return block.gap_m(start.block.solid->bounding_radius_m);
}

Quaterniond any_attitude(std::uint64_t seed) {
    config::RandomStream draw{{seed, 0, 0, 0}, config::Purpose::test};
    return Quaterniond{draw.uniform() - 0.5, draw.uniform() - 0.5, draw.uniform() - 0.5, draw.uniform() - 0.5}
        .normalized();
}

TEST(BlockStarts, OfThrownBlocksSpinAsIfTheyRolled) {
    const Slope flat = plane_slope(0.0, {0.3, 0.8});
    Law law;
    law.start_spin_radps = 6.0;
    const RockStart start =
        block_at(flat, {1.0, 0.6, 0.2}, 100.0, 50.0, 1.5, {2.0, 0.0, 0.0}, any_attitude(3));
    // Towards +x a ball rolls about +y.
    const BlockStart begin = begin_of(flat, law, start);
    EXPECT_LT((begin.body.spin_radps(*start.block.solid) - 6.0 * Vector3d::UnitY()).norm(), 1e-12);
}

TEST(BlockStarts, FallingAtTheirHeightWithTheirVelocity) {
    const Slope flat = plane_slope(0.0, {0.3, 0.8});
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const RockStart start =
            block_at(flat, {1.0, 0.6, 0.2}, 100.0, 50.0, 1.5, {2.0, 1.0, -0.5}, any_attitude(seed));
        const BlockStart begin = begin_of(flat, Law{}, start);
        EXPECT_FALSE(begin.on_ground);
        EXPECT_EQ(begin.body.velocity_mps, start.velocity_mps);
        EXPECT_NEAR(begin.body.centre_m.z() - reach_m(*start.block.solid, begin.body, -Vector3d::UnitZ()),
                    start.position_m.z(), 1e-12);
    }
}

TEST(BlockStarts, FallingNowhereBelowTheGroundOfASteepSlope) {
    const Slope steep = plane_slope(60.0, {0.3, 0.8});
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const RockStart start =
            block_at(steep, {3.0, 2.0, 0.4}, 100.0, 50.0, 0.1, {0.0, 0.0, 0.0}, any_attitude(seed));
        EXPECT_GT(gap_m(steep, Law{}, start, begin_of(steep, Law{}, start)), 0.0);
    }
}

TEST(BlockStarts, SlidingOnTheirLargestFaceAlongTheGround) {
    const Slope slope = plane_slope(30.0, {0.3, 0.8});
    Law law;
    law.start = StartKind::sliding;
    const RockStart start =
        block_at(slope, {1.0, 0.2, 0.8}, 100.0, 50.0, 0.0, {2.0, 0.0, -1.0}, any_attitude(3));
    const BlockStart begin = begin_of(slope, law, start);
    const Vector3d normal = slope.terrain.plane_of(begin.triangle).normal();
    EXPECT_TRUE(begin.on_ground);
    // The thin side is y of the given axes.
    const Vector3d thin = begin.body.rotation.attitude * (start.block.solid->from_given * Vector3d::UnitY());
    EXPECT_NEAR(std::abs(thin.dot(normal)), 1.0, 1e-9);
    EXPECT_NEAR(begin.body.velocity_mps.norm(), start.velocity_mps.norm(), 1e-12);
    EXPECT_NEAR(begin.body.velocity_mps.dot(normal), 0.0, 1e-12);
    EXPECT_NEAR(gap_m(slope, law, start, begin), 0.0, 1e-9);
}

TEST(BlockStarts, TopplingAboutAnEdgeThatStandsStill) {
    const Slope slope = plane_slope(40.0, {0.3, 0.8});
    Law law;
    law.start = StartKind::toppling;
    const RockStart start =
        block_at(slope, {0.5, 0.5, 2.0}, 100.0, 50.0, 0.0, {0.0, 0.0, 0.0}, any_attitude(5));
    const BlockStart begin = begin_of(slope, law, start);
    const Body& body = begin.body;
    EXPECT_TRUE(begin.on_ground);
    EXPECT_NEAR(gap_m(slope, law, start, begin), 0.0, 1e-9);
    const Vector3d spin_radps = body.spin_radps(*start.block.solid);
    EXPECT_NEAR(spin_radps.norm(), law.topple_spin_radps, 1e-12);
    EXPECT_NEAR(spin_radps.z(), 0.0, 1e-12);
    EXPECT_GT(body.velocity_mps.x(), 0.0);
    // The two vertices of the edge do not move.
    int at_rest = 0;
    for (const Vector3d& vertex_m : start.block.solid->hull.vertices_m) {
        const Vector3d arm_m = body.rotation.attitude * vertex_m;
        at_rest += (body.velocity_mps + spin_radps.cross(arm_m)).norm() < 1e-9 ? 1 : 0;
    }
    EXPECT_EQ(at_rest, 2);
}

TEST(BlockStarts, TopplingColumnsFallOverAndCannotGoBack) {
    const Slope flat = plane_slope(0.0, {0.3, 0.8});
    FallLaw law = rigid_law();
    law.motion.of<Model>() = law_of(0.9, 0.0);
    law.motion.of<Model>().start = StartKind::toppling;
    law.motion.of<Model>().topple_spin_radps = 0.0;
    const RockStart start = block_at(flat, {0.5, 0.5, 2.0}, 100.0, 50.0, 0.0, {0.0, 0.0, 0.0});
    const auto [end, log] = logged_fall(flat, law, start);
    EXPECT_EQ(end.reason, StopReason::at_rest);
    // From 1 m above its edge to 0.25 m above the ground beside it.
    EXPECT_NEAR(end.dissipated_j, start.block.solid->mass_kg * config::gravity_mps2 * (1.03 - 0.25),
                0.02 * end.dissipated_j);
}

/// A drop of a plate beside a stem at 105, in its way or past it.
std::pair<FallEnd, EventLog> past_stem(double beside_m, const Quaterniond& attitude) {
    const Slope slope = plane_slope(20.0, {0.3, 0.8});
    const StemIndex stems{std::vector<Stem>{{105.0, 50.0 + beside_m, 40.0, 25.0, 1.0}}, slope.terrain, 1.0,
                          false};
    const RockStart start = block_at(slope, {1.4, 1.4, 0.2}, 102.0, 50.0, 2.0, {15.0, 0.0, 2.0}, attitude);
    return logged_fall(slope, rigid_law(), start, &stems);
}

TEST(BlockAmongTrees, HitsAStemWithTheBlockItselfNotWithItsBall) {
    const Quaterniond lying = Quaterniond::Identity();
    const Quaterniond upright{Eigen::AngleAxisd{0.5 * 3.14159265358979, Vector3d::UnitX()}};
    // The ball around the plate reaches 0.995 m, the plate 0.7 m lying and 0.1 m upright; the stem has 0.2 m.
    EXPECT_EQ(past_stem(0.85, lying).second.hits.size(), 1U);
    EXPECT_EQ(past_stem(0.95, lying).second.hits.size(), 0U);
    EXPECT_EQ(past_stem(0.25, upright).second.hits.size(), 1U);
    EXPECT_EQ(past_stem(0.35, upright).second.hits.size(), 0U);
    EXPECT_EQ(past_stem(0.85, upright).second.hits.size(), 0U);
}

TEST(BlockAmongTrees, GivesAStemTheEnergyOfItsParabola) {
    const auto [end, log] = past_stem(0.0, Quaterniond::Identity());
    ASSERT_FALSE(log.hits.empty());
    const double mass_kg = 2700.0 * 1.4 * 1.4 * 0.2;
    const double time_s = (3.0 - 0.7 - 0.2) / 15.0;
    const double up_mps = 2.0 - config::gravity_mps2 * time_s;
    EXPECT_NEAR(log.hits[0].energy_j, 0.5 * mass_kg * (15.0 * 15.0 + up_mps * up_mps), 30.0);
    EXPECT_NEAR(log.hits[0].hit.offset_m, 0.0, 1e-9);
}

TEST(BlockAmongLogs, MeetsALogItTouches) {
    const Slope slope = plane_slope(20.0, {0.3, 0.8});
    const LogIndex logs{std::vector<Log>{{105.0, 45.0, 105.0, 55.0, 60.0, 60.0, 0.0, 1.0, 1.0, true}},
                        slope.terrain, 1.0, 0.5};
    Obstacles obstacles;
    obstacles.logs = &logs;
    const RockStart start = block_at(slope, {1.0, 0.8, 0.5}, 102.0, 50.0, 0.3, {9.0, 0.0, -2.0});
    const auto [end, log] = logged_fall(slope, rigid_law(), start, obstacles);
    ASSERT_FALSE(log.logs.empty());
    EXPECT_GT(log.logs[0].energy_j, 0.0);
    const RockStart beside = block_at(slope, {1.0, 0.8, 0.5}, 102.0, 57.0, 0.3, {9.0, 0.0, -2.0});
    EXPECT_TRUE(logged_fall(slope, rigid_law(), beside, obstacles).second.logs.empty());
}

TEST(BlockPastANet, IsHeldWithTheEnergyOfTranslationAndRotation) {
    const Slope slope = plane_slope(35.0, {0.3, 0.8});
    const Eigen::Vector2d origin_m = slope.terrain.origin_m();
    const NetIndex nets{
        std::vector<Net>{{{Eigen::Vector2d{112.0, 10.0} - origin_m, Eigen::Vector2d{112.0, 90.0} - origin_m},
                          60.0,
                          0.0,
                          1e12}}};
    Obstacles obstacles;
    obstacles.nets = &nets;
    const RockStart start = block_at(slope, {1.0, 0.8, 0.5}, 105.0, 50.0, 20.0, {6.0, 0.5, 1.0});
    const auto [end, log] = logged_fall(slope, rigid_law(), start, obstacles);
    EXPECT_EQ(end.reason, StopReason::net);
    ASSERT_EQ(log.nets.size(), 1U);
    const double time_s = 7.0 / 6.0;
    const double drop_m = 0.5 * config::gravity_mps2 * time_s * time_s - 1.0 * time_s;
    const double squared_speed = 36.0 + 0.25 + 1.0 + 2.0 * config::gravity_mps2 * drop_m;
    EXPECT_NEAR(log.nets[0].crossing.energy_j, 0.5 * start.block.solid->mass_kg * squared_speed, 1e-6);
    // All energy is booked: at the net it is taken whole.
    EXPECT_NEAR(end.residual_j, 0.0, 1e-9 * end.dissipated_j);
    // Rocks are stopped 1 mm before the plane of the net.
    EXPECT_NEAR(end.dissipated_j, log.nets[0].crossing.energy_j, 1e-3 * end.dissipated_j);
}

/// A rough slope with a wood.
Slope rough_slope(std::uint64_t seed) {
    const config::GridFrame frame{60, 40, 0.0, 0.0, 5.0, 5.0};
    std::uint64_t k = 0;
    return slope_over(heights_of(frame,
                                 [&](double x, double) {
                                     config::RandomStream cell{{seed, 1, 0, k++}, config::Purpose::test};
                                     return 500.0 - 0.7 * x + 0.8 * cell.uniform();
                                 }),
                      {0.35, 0.85});
}

TEST(BlockFalls, CloseTheirLedgersOnRoughGroundWithTrees) {
    // Goal: 1e-3 of what was dissipated, for every rock.
    const std::array<Vector3d, 3> shapes{Vector3d{0.8, 0.8, 0.8}, {1.3, 1.2, 0.3}, {2.0, 0.5, 0.5}};
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const Slope slope = rough_slope(seed);
        std::vector<Stem> trees;
        for (std::size_t i = 0; i < 200; ++i) {
            config::RandomStream stream{{seed, 2, 0, i}, config::Purpose::test};
            trees.push_back({10.0 + 280.0 * stream.uniform(), 10.0 + 180.0 * stream.uniform(),
                             10.0 + 50.0 * stream.uniform(), 20.0, 1.0});
        }
        const StemIndex stems{trees, slope.terrain, 1.5, true};
        const RockStart start =
            block_at(slope, shapes[seed % 3], 20.0, 100.0, 1.5, {3.0, 0.5, -1.5}, any_attitude(seed), seed);
        FallLaw law = rigid_law();
        law.motion.of<Model>().restitution = seed % 2 == 0 ? 0.3 : -1.0;
        const auto [end, log] = logged_fall(slope, law, start, &stems);
        EXPECT_GT(end.dissipated_j, 0.0);
        EXPECT_LE(std::abs(end.residual_j), 1e-3 * end.dissipated_j) << seed;
        EXPECT_LE(end.corrected_j, 0.0);
        EXPECT_GE(end.corrected_j, -1e-2 * end.dissipated_j) << seed;
        EXPECT_NE(end.reason, StopReason::gave_up);
    }
}

/// A block that flies level over flat ground, and what was watched.
struct WatchedBlock {
    std::vector<TargetArrival> arrivals;
    std::vector<PathPoint> path;
    double radius_m;
    RockRecord record;
};

WatchedBlock watch_block(const Slope& slope, const RockStart& start, bool with_path) {
    const Eigen::Vector2d origin_m = slope.terrain.origin_m();
    Target line;
    line.parts = {{Eigen::Vector2d{105.0, 10.0} - origin_m, Eigen::Vector2d{105.0, 90.0} - origin_m}};
    const std::vector<Target> targets{with_bounds(line)};
    const config::GridFrame frame{100, 20, -origin_m.x(), -origin_m.y(), 5.0, 5.0};
    Footprint footprint{slope.terrain, frame, targets};
    FallScratch scratch;
    footprint.begin(start, with_path);
    footprint.finish(fall(slope, Obstacles{}, rigid_law(), {1, 0, 0, start.id}, start, scratch, footprint));
    return {{footprint.arrivals().begin(), footprint.arrivals().end()},
            {footprint.path().begin(), footprint.path().end()},
            start.rock.radius_m,
            footprint.record()};
}

TEST(BlockFootprint, HasTheHeightsOfCentreAndHighestPointAtATarget) {
    const Slope flat = plane_slope(0.0, {0.3, 0.8});
    const RockStart start = block_at(flat, {1.0, 0.6, 0.4}, 102.0, 50.0, 5.0, {10.0, 0.0, 0.0});
    const WatchedBlock watched = watch_block(flat, start, false);
    ASSERT_EQ(watched.arrivals.size(), 1U);
    const double lowest_m = 5.0 - 0.5 * config::gravity_mps2 * 0.3 * 0.3;
    const Arrival& arrival = watched.arrivals[0].arrival;
    EXPECT_NEAR(arrival.centre_height_m, lowest_m + 0.2, 1e-5);
    EXPECT_NEAR(arrival.top_height_m, lowest_m + 0.4, 1e-5);
    EXPECT_NEAR(arrival.height_m, lowest_m + 0.2 - start.rock.radius_m, 1e-5);
}

TEST(BlockFootprint, DrawsThePathWithAttitudesAndFewCorners) {
    const Slope slope = rough_slope(3);
    const RockStart start =
        block_at(slope, {1.0, 0.9, 0.3}, 20.0, 100.0, 1.5, {3.0, 0.5, -1.5}, any_attitude(2));
    const WatchedBlock watched = watch_block(slope, start, true);
    const WatchedBlock other = watch_block(slope, start, false);
    EXPECT_EQ(watched.record.path_m, other.record.path_m);
    EXPECT_EQ(watched.record.end_m, other.record.end_m);
    ASSERT_GT(watched.path.size(), 2U);
    for (const PathPoint& point : watched.path) {
        double square = 0.0;
        for (const float part : point.attitude) {
            square += static_cast<double>(part) * static_cast<double>(part);
        }
        EXPECT_NEAR(square, 1.0, 1e-5);
    }
    // At most nine corners of each flight, and on the ground one a radius.
    EXPECT_LT(static_cast<double>(watched.path.size()),
              9.0 * watched.record.jumps + watched.record.path_m / watched.radius_m + 10.0);
    EXPECT_LT((watched.path.back().position_m - watched.record.end_m).head<2>().norm(), 1e-6);
}

/// Root of the mean square of the angle between the way of blocks of one shape and the fall line [rad].
double spread_rad(const solids::Hull& shape, std::uint64_t blocks) {
    const config::GridFrame frame{100, 80, 0.0, 0.0, 4.0, 4.0};
    std::uint64_t k = 0;
    const Slope slope =
        slope_over(heights_of(frame,
                              [&](double x, double) {
                                  config::RandomStream cell{{33, 1, 0, k++}, config::Purpose::test};
                                  return 500.0 - std::tan(radians(33.0)) * x + 0.9 * (cell.uniform() - 0.5);
                              }),
                   {0.35, 0.85});
    const auto solid =
        std::make_shared<const solids::Solid>(solids::solid_of(solids::with_volume(shape, 0.27), 2700.0));
    double squares = 0.0;
    for (std::uint64_t id = 0; id < blocks; ++id) {
        RockStart start = start_at(slope, 20.0, 160.0, 1.5, {2.6, 0.0, -1.5}, solid->diameter_m(), id);
        start.block = {solid, any_attitude(id)};
        start.heading = Eigen::Vector2d::UnitX();
        const Vector3d way_m = logged_fall(slope, rigid_law(), start).first.position_m - start.position_m;
        const double angle_rad = std::atan2(way_m.y(), way_m.x());
        squares += angle_rad * angle_rad;
    }
    return std::sqrt(squares / static_cast<double>(blocks));
}

TEST(BlockFalls, OfWheelsSpreadMoreToTheSideThanThoseOfCompactBlocksOfEqualMass) {
    // Caviezel et al. 2021. The root of the mean square of n draws has a relative error of 1 / sqrt(2 n): of
    // the ratio of two sqrt(1 / n). Four of those are half of the ratio at n = 60.
    constexpr std::uint64_t blocks = 60;
    const double four_errors = 4.0 / std::sqrt(static_cast<double>(blocks));
    const double wheels_rad = spread_rad(solids::ellipsoid({1.0, 1.0, 0.5}, 2), blocks);
    const double compact_rad = spread_rad(solids::ellipsoid({1.0, 1.0, 0.99}, 2), blocks);
    EXPECT_GT(wheels_rad, (1.0 + four_errors) * compact_rad) << wheels_rad << " and " << compact_rad;
}

TEST(BlockFalls, OfSpheresEndOnGentleGroundAndInItsTroughs) {
    // Drag alone lets a sphere creep for ever: at 0.08 degrees with 0.02 m/s, at 0.5 degrees with 0.1 m/s.
    const config::GridFrame frame{60, 20, 0.0, 0.0, 5.0, 5.0};
    for (const double slope_deg : {0.08, 0.5}) {
        for (const double across : {0.0, 0.1}) {
            const Slope slope = slope_over(heights_of(frame,
                                                      [&](double x, double y) {
                                                          return 500.0 - std::tan(radians(slope_deg)) * x +
                                                                 across * std::abs(y - 52.5);
                                                      }),
                                           {0.35, 0.85});
            const RockStart ball = start_at(slope, 20.0, 60.0, 0.5, {3.0, 0.5, -1.5}, 0.9);
            FallLaw law = rigid_law();
            EXPECT_EQ(logged_fall(slope, law, ball).first.reason, StopReason::at_rest)
                << slope_deg << " deg, across " << across;
            law.motion.of<Model>().rolling_resistance = 0.0;
            law.motion.of<Model>().longest_s = 120.0;
            EXPECT_NE(logged_fall(slope, law, ball).first.reason, StopReason::at_rest)
                << slope_deg << " deg, across " << across << ": without resistance";
        }
    }
}

TEST(BlockFalls, AreThoseOfASphereWhereNoShapeIsGiven) {
    const Slope slope = plane_slope(30.0, {0.3, 0.8});
    RockStart ball = start_at(slope, 50.0, 50.0, 1.5, {3.0, 0.5, -1.5}, 0.9);
    const auto [end, log] = logged_fall(slope, rigid_law(), ball);
    ball.block.solid = std::make_shared<const solids::Solid>(solids::ball_of(0.9, 2700.0));
    ball.block.attitude = any_attitude(1);
    const auto [same_end, same_log] = logged_fall(slope, rigid_law(), ball);
    EXPECT_NEAR((end.position_m - same_end.position_m).norm(), 0.0, 1e-6);
    EXPECT_EQ(end.ground_impacts, same_end.ground_impacts);
}

}  // namespace
}  // namespace rockfall::rigid::testing
