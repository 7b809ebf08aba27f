#include "rockfall/tally/footprint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/rockfall/slopes.hpp"

namespace rockfall::footprint_test {
namespace {

using testing::deterministic_law;
using testing::EventLog;
using testing::heights_of;
using testing::logged_fall;
using testing::slope_over;
using testing::start_at;

Slope wavy_slope() {
    const config::GridFrame frame{80, 40, 0.0, 0.0, 2.5, 2.5};
    return slope_over(heights_of(frame,
                                 [](double x, double y) {
                                     return 300.0 - 0.7 * x + 1.5 * std::sin(x / 7.0) * std::cos(y / 9.0);
                                 }),
                      {0.35, 0.85}, 0.0);
}

FallLaw lively_law() {
    FallLaw law;
    law.tree.deviation = deterministic_law().tree.deviation;
    return law;
}

struct Watched {
    RockRecord record;
    std::vector<CellVisit> visits;
    std::vector<TargetArrival> arrivals;
};

Watched watch(const Slope& slope, const config::GridFrame& frame, const RockStart& start,
              bool with_path = false, std::span<const Target> targets = {}) {
    Footprint footprint{slope.terrain, frame, targets};
    FallScratch scratch;
    footprint.begin(start, with_path);
    footprint.finish(fall(slope, Obstacles{}, lively_law(), {1, 0, 0, start.id}, start, scratch, footprint));
    return {footprint.record(),
            {footprint.visits().begin(), footprint.visits().end()},
            {footprint.arrivals().begin(), footprint.arrivals().end()}};
}

config::GridFrame on_terrain(config::GridFrame frame, const Slope& slope) {
    frame.x_west_m -= slope.terrain.origin_m().x();
    frame.y_south_m -= slope.terrain.origin_m().y();
    return frame;
}

TEST(Footprint, HoldsTheExactExtremesOfEachCell) {
    // Every flight sampled a thousandfold finds nothing above what the cells hold, and nearly all of it.
    const Slope slope = wavy_slope();
    const config::GridFrame frame = on_terrain({50, 25, 0.0, 0.0, 4.0, 4.0}, slope);
    for (std::uint64_t rock = 0; rock < 20; ++rock) {
        const RockStart start = start_at(slope, 10.0, 50.0, 1.5, {3.0, 0.5, -1.5}, 0.9, rock);
        const Watched watched = watch(slope, frame, start);
        const auto [end, log] = logged_fall(slope, lively_law(), start);
        std::map<std::uint32_t, std::array<double, 3>> sampled;
        for (const EventLog::Jump& jump : log.jumps) {
            for (int i = 0; i <= 1000; ++i) {
                const double t = jump.until_s * i / 1000.0;
                const Eigen::Vector3d p = jump.flight.position_m(t);
                const config::Cell cell = frame.cell_at(p.x(), p.y());
                const auto triangle = slope.terrain.locate(p.x(), p.y(), jump.stretches.front().triangle);
                if (!frame.contains(cell) || !triangle) {
                    continue;
                }
                auto& best = sampled[static_cast<std::uint32_t>(frame.index(cell))];
                const double speed = std::sqrt(jump.flight.squared_speed_at(t));
                const Plane plane = slope.terrain.plane_of(*triangle);
                best[0] = std::max(best[0], kinetic_energy_j(start.rock, speed * speed, jump.spin_radps));
                best[1] = std::max(best[1], speed);
                best[2] = std::max(best[2], (p.z() - plane.height_m(p.x(), p.y())) * plane.normal().z());
            }
        }
        for (const CellVisit& visit : watched.visits) {
            const auto found = sampled.find(visit.cell);
            if (found == sampled.end()) {
                continue;  // a corner cut shorter than the sampling
            }
            EXPECT_GE(visit.energy_j, found->second[0] * (1.0 - 1e-5));
            EXPECT_GE(visit.speed_mps, found->second[1] * (1.0 - 1e-5));
            EXPECT_GE(visit.height_m, found->second[2] - 1e-4);
            EXPECT_LE(visit.speed_mps, found->second[1] + 0.3);
            EXPECT_LE(visit.height_m, found->second[2] + 0.1);
        }
        EXPECT_GE(watched.visits.size(), sampled.size());
    }
}

TEST(Footprint, CountsARockOnceInACell) {
    const Slope slope = wavy_slope();
    const config::GridFrame frame = on_terrain({50, 25, 0.0, 0.0, 4.0, 4.0}, slope);
    const Watched watched = watch(slope, frame, start_at(slope, 10.0, 50.0, 1.5, {3.0, 0.5, -1.5}));
    std::map<std::uint32_t, int> seen;
    for (const CellVisit& visit : watched.visits) {
        EXPECT_EQ(++seen[visit.cell], 1);
    }
}

TEST(Footprint, DoesNotDependOnDrawing) {
    const Slope slope = wavy_slope();
    const config::GridFrame frame = on_terrain({50, 25, 0.0, 0.0, 4.0, 4.0}, slope);
    const RockStart start = start_at(slope, 10.0, 50.0, 1.5, {3.0, 0.5, -1.5});
    const Watched plain = watch(slope, frame, start, false);
    const Watched drawn = watch(slope, frame, start, true);
    ASSERT_EQ(plain.visits.size(), drawn.visits.size());
    for (std::size_t i = 0; i < plain.visits.size(); ++i) {
        EXPECT_EQ(plain.visits[i].energy_j, drawn.visits[i].energy_j);
        EXPECT_EQ(plain.visits[i].height_m, drawn.visits[i].height_m);
    }
}

TEST(Footprint, FindsTheSameLargestValuesWithAnyCellSize) {
    // Refining the maps must not change what rocks do, nor lose a passage.
    const Slope slope = wavy_slope();
    const RockStart start = start_at(slope, 10.0, 50.0, 1.5, {3.0, 0.5, -1.5});
    double coarse_max = 0.0;
    for (const int side : {1, 2, 5, 20}) {
        const config::GridFrame frame =
            on_terrain({200 / side, 100 / side, 0.0, 0.0, 1.0 * side, 1.0 * side}, slope);
        const Watched watched = watch(slope, frame, start);
        float largest = 0.0F;
        for (const CellVisit& visit : watched.visits) {
            largest = std::max(largest, visit.energy_j);
        }
        coarse_max = coarse_max == 0.0 ? static_cast<double>(largest) : coarse_max;
        EXPECT_FLOAT_EQ(largest, static_cast<float>(coarse_max));
        EXPECT_FLOAT_EQ(largest, static_cast<float>(watched.record.max_energy_j));
    }
}

TEST(Footprint, WithoutCellsKeepsAllElse) {
    const Slope slope = wavy_slope();
    const Eigen::Vector2d o = slope.terrain.origin_m();
    Target road;
    road.parts = {{Eigen::Vector2d{150.0, 1.5} - o, Eigen::Vector2d{150.0, 98.0} - o}};
    const std::vector<Target> targets{with_bounds(road)};
    const config::GridFrame frame = on_terrain({50, 25, 0.0, 0.0, 4.0, 4.0}, slope);
    for (std::uint64_t rock = 0; rock < 40; ++rock) {
        const RockStart start = start_at(slope, 10.0, 50.0, 1.5, {3.0, 0.5, -1.5}, 0.9, rock);
        const Watched with = watch(slope, frame, start, false, targets);
        const Watched without = watch(slope, {}, start, false, targets);
        EXPECT_FALSE(with.visits.empty());
        EXPECT_TRUE(without.visits.empty());
        EXPECT_EQ(without.record.end_m, with.record.end_m);
        EXPECT_EQ(without.record.max_energy_j, with.record.max_energy_j);
        EXPECT_EQ(without.record.min_speed_mps, with.record.min_speed_mps);
        EXPECT_EQ(without.record.path_m, with.record.path_m);
        // A flight that is cut at cells is looked at in other places.
        EXPECT_NEAR(without.record.max_height_m, with.record.max_height_m, 1e-12);
        EXPECT_NEAR(without.record.jump_height_sum_m, with.record.jump_height_sum_m, 1e-9);
        ASSERT_EQ(without.arrivals.size(), with.arrivals.size());
        for (std::size_t i = 0; i < with.arrivals.size(); ++i) {
            EXPECT_EQ(without.arrivals[i].arrival.energy_j, with.arrivals[i].arrival.energy_j);
        }
    }
}

TEST(Footprint, TellsHowARockArrivesAtALine) {
    const Slope slope = wavy_slope();
    const config::GridFrame frame = on_terrain({50, 25, 0.0, 0.0, 4.0, 4.0}, slope);
    Target road;
    const Eigen::Vector2d o = slope.terrain.origin_m();
    road.parts = {{Eigen::Vector2d{150.0, 1.5} - o, Eigen::Vector2d{150.0, 98.0} - o}};
    const std::vector<Target> targets{with_bounds(road)};
    const RockStart start = start_at(slope, 10.0, 50.0, 1.5, {3.0, 0.5, -1.5});
    const Watched watched = watch(slope, frame, start, false, targets);
    ASSERT_EQ(watched.arrivals.size(), 1U);
    ASSERT_TRUE(watched.arrivals[0].arrival.reached);
    EXPECT_NEAR(watched.arrivals[0].arrival.x_m + o.x(), 150.0, 1e-3);
    const auto [end, log] = logged_fall(slope, lively_law(), start);
    for (const EventLog::Jump& jump : log.jumps) {
        const double t = (150.0 - o.x() - jump.flight.start_m.x()) / jump.flight.velocity_mps.x();
        if (t >= 0.0 && t <= jump.until_s) {
            const double speed = std::sqrt(jump.flight.squared_speed_at(t));
            EXPECT_NEAR(watched.arrivals[0].arrival.speed_mps, speed, 1e-3);
            EXPECT_NEAR(watched.arrivals[0].arrival.energy_j,
                        kinetic_energy_j(start.rock, speed * speed, jump.spin_radps), 1.0);
            EXPECT_NEAR(watched.arrivals[0].arrival.translational_j, 0.5 * start.rock.mass_kg * speed * speed,
                        1.0);
            break;
        }
    }
}

TEST(Footprint, CountsARockWhoseSideTouchesAHouse) {
    const Slope slope = wavy_slope();
    const config::GridFrame frame = on_terrain({50, 25, 0.0, 0.0, 4.0, 4.0}, slope);
    const Eigen::Vector2d o = slope.terrain.origin_m();
    const RockStart start = start_at(slope, 10.0, 50.0, 1.5, {3.0, 0.5, -1.5});
    Target line;
    line.parts = {{Eigen::Vector2d{150.0, 1.5} - o, Eigen::Vector2d{150.0, 98.0} - o}};
    const Watched crossing = watch(slope, frame, start, false, std::vector{with_bounds(line)});
    ASSERT_EQ(crossing.arrivals.size(), 1U);
    const double y_m = static_cast<double>(crossing.arrivals[0].arrival.y_m);
    const double x_m = 150.0 - o.x();
    // A post of a millimetre beside the way, and the line across it.
    const auto post = [&](double beside_m, bool by_side) {
        Target target;
        target.is_area = true;
        target.is_hit_by_side = by_side;
        target.parts = {{{x_m, y_m + beside_m},
                         {x_m + 1e-3, y_m + beside_m},
                         {x_m + 1e-3, y_m + beside_m + 1e-3},
                         {x_m, y_m + beside_m}}};
        return with_bounds(target);
    };
    const double radius_m = start.rock.radius_m;
    line.is_hit_by_side = true;
    const std::vector<Target> targets{post(0.5 * radius_m, true), post(0.5 * radius_m, false),
                                      post(3.0 * radius_m, true), with_bounds(line)};
    const Watched watched = watch(slope, frame, start, false, targets);
    ASSERT_EQ(watched.arrivals.size(), 2U);
    const Arrival& touched = watched.arrivals[0].arrival;
    EXPECT_EQ(watched.arrivals[0].target, 0U);
    EXPECT_TRUE(touched.by_side);
    EXPECT_NEAR(std::hypot(touched.x_m - x_m, touched.y_m - (y_m + 0.5 * radius_m)), radius_m, 2e-3);
    EXPECT_NEAR(touched.energy_j, crossing.arrivals[0].arrival.energy_j, 0.1 * touched.energy_j);
    // Where the centre crosses a line, the side that touched it first is forgotten.
    EXPECT_EQ(watched.arrivals[1].target, 3U);
    EXPECT_FALSE(watched.arrivals[1].arrival.by_side);
    EXPECT_EQ(watched.arrivals[1].arrival.energy_j, crossing.arrivals[0].arrival.energy_j);
    EXPECT_EQ(watched.arrivals[1].arrival.x_m, crossing.arrivals[0].arrival.x_m);
}

TEST(Footprint, MeasuresRunOutAndPathOfASlidingLine) {
    const Slope slope = testing::plane_slope(20.0, {0.3, 0.75});
    const config::GridFrame frame = on_terrain({100, 10, 0.0, 0.0, 10.0, 10.0}, slope);
    const double b = config::Angle::from_degrees(20.0).in_radians();
    const RockStart start =
        start_at(slope, 100.0, 50.0, 0.0, 1.0 * Eigen::Vector3d{std::cos(b), 0.0, -std::sin(b)});
    const Watched watched = watch(slope, frame, start);
    EXPECT_NEAR(watched.record.path_m * std::cos(b), watched.record.run_out_m(), 1e-6);
    EXPECT_EQ(watched.record.max_height_m, 0.0);
    EXPECT_DOUBLE_EQ(watched.record.max_speed_mps, 1.0);
    EXPECT_NEAR(watched.record.max_energy_j, 0.7 * start.rock.mass_kg, 1e-6);  // a rolling sphere: 0.7 m v^2
}

TEST(Footprint, MeasuresPathAndMeanSpeedOfARockThatHopsOnTheSpot) {
    // Dropped from 10 m, half the speed kept at each impact, ended by the fourth: 10 + 2 (10/4 + 10/16 +
    // 10/64) = 16.5625 m, in sqrt(2 * 10 / g) (1 + 2 (1/2 + 1/4 + 1/8)) s.
    const Slope slope = testing::plane_slope(0.0, {0.5, 0.5});
    Footprint footprint{slope.terrain, on_terrain({100, 10, 0.0, 0.0, 10.0, 10.0}, slope), {}};
    RockStart start = start_at(slope, 100.0, 50.0, 10.0, Eigen::Vector3d::Zero());
    footprint.begin(start, false);
    std::vector<Stretch> stretches;
    Flight flight{start.position_m, start.velocity_mps};
    for (int impact = 1; impact <= 4; ++impact) {
        const Landing landing = fly(slope.terrain, flight, start.triangle, stretches);
        footprint.flew(start.rock, flight, landing.time_s, stretches, 0.0);
        flight.start_m.z() = stretches.back().ground_end_m;
        flight.velocity_mps.z() = -0.5 * flight.velocity_at(landing.time_s).z();
    }
    EXPECT_NEAR(footprint.record().path_m, 16.5625, 1e-6);
    EXPECT_NEAR(footprint.record().mean_speed_mps(),
                16.5625 / (std::sqrt(20.0 / config::gravity_mps2) * 2.75), 1e-6);
}

TEST(Footprint, RecordsJumpLengthsAndSpeedsOfEveryEvent) {
    const Slope slope = wavy_slope();
    const config::GridFrame frame = on_terrain({50, 25, 0.0, 0.0, 4.0, 4.0}, slope);
    for (std::uint64_t rock = 0; rock < 20; ++rock) {
        const RockStart start = start_at(slope, 10.0, 50.0, 1.5, {3.0, 0.5, -1.5}, 0.9, rock);
        const RockRecord record = watch(slope, frame, start).record;
        const auto [end, log] = logged_fall(slope, lively_law(), start);
        double least_mps = start.velocity_mps.norm();
        std::vector<double> lengths_m;
        for (const EventLog::Jump& jump : log.jumps) {
            for (int i = 0; i <= 4000; ++i) {
                const double t = jump.until_s * i / 4000.0;
                least_mps = std::min(least_mps, std::sqrt(jump.flight.squared_speed_at(t)));
            }
            const double length_m = (jump.flight.position_m(jump.until_s) - jump.flight.start_m).norm();
            if (length_m >= 1e-3) {
                lengths_m.push_back(length_m);
            }
        }
        for (const EventLog::Roll& roll : log.rolls) {
            least_mps = std::min({least_mps, roll.piece.velocity_mps.norm(),
                                  roll.piece.velocity_at(roll.piece.duration_s).norm()});
        }
        EXPECT_NEAR(record.min_speed_mps, least_mps, 2e-3);
        EXPECT_LE(record.min_speed_mps, least_mps + 1e-12);  // sampling misses the apex, the record does not
        ASSERT_FALSE(lengths_m.empty());
        double sum_m = 0.0;
        for (const double length_m : lengths_m) {
            sum_m += length_m;
        }
        EXPECT_DOUBLE_EQ(record.min_jump_length_m, *std::min_element(lengths_m.begin(), lengths_m.end()));
        EXPECT_DOUBLE_EQ(record.max_jump_length_m, *std::max_element(lengths_m.begin(), lengths_m.end()));
        EXPECT_NEAR(record.mean_jump_length_m(), sum_m / static_cast<double>(lengths_m.size()), 1e-9);
    }
}

TEST(Footprint, CountsImpactsByGround) {
    Slope slope = wavy_slope();
    SurfaceType lower = slope.types.front();
    lower.code = 7;
    slope.types.push_back(lower);
    // The eastern half is ground 7.
    const config::GridFrame halves{2,     1,    -slope.terrain.origin_m().x(), -slope.terrain.origin_m().y(),
                                   100.0, 100.0};
    slope.surface = SurfaceMap{halves, {0, 1}};
    const config::GridFrame frame = on_terrain({50, 25, 0.0, 0.0, 4.0, 4.0}, slope);
    const RockStart start = start_at(slope, 10.0, 50.0, 1.5, {3.0, 0.5, -1.5});
    const RockRecord record = watch(slope, frame, start).record;
    const auto [end, log] = logged_fall(slope, lively_law(), start);
    const double middle_m = 100.0 - slope.terrain.origin_m().x();
    const auto in_east = static_cast<std::uint32_t>(
        std::count_if(log.impacts.begin(), log.impacts.end(),
                      [&](const Eigen::Vector3d& at) { return at.x() >= middle_m; }));
    ASSERT_EQ(record.impacts_by_ground.size(), 2U);
    EXPECT_EQ(record.impacts_by_ground[0].ground, 1);
    EXPECT_EQ(record.impacts_by_ground[1].ground, 7);
    EXPECT_EQ(record.impacts_by_ground[1].impacts, in_east);
    EXPECT_EQ(record.impacts_by_ground[0].impacts + in_east, record.ground_impacts);
}

}  // namespace
}  // namespace rockfall::footprint_test
