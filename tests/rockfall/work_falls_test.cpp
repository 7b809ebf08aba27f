// Whole falls at dams, ditches and roofs.

#include <gtest/gtest.h>

#include <cmath>

#include "config/units/constants.hpp"
#include "rockfall/tally/footprint.hpp"
#include "rockfall/terrain/embankment.hpp"
#include "tests/rockfall/slopes.hpp"

namespace rockfall::work_falls_test {
namespace {

using config::gravity_mps2;
using testing::deterministic_law;
using testing::EventLog;
using testing::logged_fall;
using testing::plane_slope;
using testing::sliding_law;
using testing::start_at;

constexpr Restitution soft{0.30, 0.80};

/// A plane that falls towards +x with a dam across it.
Slope slope_with_dam(double slope_deg, double x_m, double rise_m, double uphill_tangent,
                     Restitution restitution = soft) {
    Slope slope = plane_slope(slope_deg, restitution, 0.0, 400.0);
    const Eigen::Vector2d origin_m = slope.terrain.origin_m();
    const EmbankmentResult result =
        place({{Eigen::Vector2d{x_m, 12.0} - origin_m, Eigen::Vector2d{x_m, 88.0} - origin_m},
               rise_m,
               2.0,
               uphill_tangent,
               1.5},
              slope.terrain);
    slope.terrain = with_embankment(slope.terrain, result.placed.value(), 0);
    return slope;
}

double top_of_energy_m(const Rock& rock, const Eigen::Vector3d& position_m, double squared_speed,
                       double spin_radps) {
    return position_m.z() +
           (0.5 * rock.mass_kg * squared_speed + 0.5 * rock.inertia_kgm2 * spin_radps * spin_radps) /
               (rock.mass_kg * gravity_mps2);
}

TEST(FallAtADam, NeverGainsEnergyOnItsFaces) {
    for (const double uphill_tangent : {0.8, 2.0, 5.0}) {
        const Slope slope = slope_with_dam(25.0, 200.0, 5.0, uphill_tangent);
        for (const FallLaw& law : {deterministic_law(), sliding_law()}) {
            std::size_t on_dam = 0;
            for (int i = 0; i < 12; ++i) {
                const RockStart start =
                    start_at(slope, 150.0 + 2.0 * i, 30.0 + 3.0 * i, 0.5 * i, {8.0 + i, 0.3 * i, 0.0});
                const auto [end, log] = logged_fall(slope, law, start, Obstacles{}, 3);
                double energy_m = std::numeric_limits<double>::infinity();
                for (const EventLog::Jump& jump : log.jumps) {
                    const double at_start =
                        top_of_energy_m(start.rock, jump.flight.start_m,
                                        jump.flight.velocity_mps.squaredNorm(), jump.spin_radps);
                    EXPECT_LE(at_start, energy_m + 1e-6) << uphill_tangent << ", rock " << i;
                    energy_m = at_start;
                    const double x_m =
                        jump.flight.position_m(jump.until_s).x() + slope.terrain.origin_m().x();
                    on_dam += x_m > 190.0 && x_m < 215.0 ? 1 : 0;
                }
            }
            EXPECT_GT(on_dam, 6U) << "rocks land on it, " << uphill_tangent;
        }
    }
}

TEST(FallAtADam, IsOverOnlyWithTheEnergyOfItsHeight) {
    // The crown lies 6 m above the ground at the axis; rocks roll towards it.
    const Slope slope = slope_with_dam(20.0, 200.0, 6.0, 1.5);
    const auto height_at = [&](double x_m) {
        return slope.terrain.height_m(x_m - slope.terrain.origin_m().x(), 50.0 - slope.terrain.origin_m().y())
            .value();
    };
    const double crown_m = height_at(200.0);
    std::size_t held = 0;
    for (const double speed_mps : {2.0, 4.0, 6.0, 8.0, 10.0, 12.0, 25.0, 40.0}) {
        const RockStart start = start_at(slope, 188.0, 50.0, 0.0, {speed_mps, 0.0, 0.0});
        for (const FallLaw& law : {deterministic_law(), sliding_law()}) {
            const auto [end, log] = logged_fall(slope, law, start, Obstacles{}, 3);
            const bool is_over = end.position_m.x() + slope.terrain.origin_m().x() > 201.0;
            // A rolling ball has 7/5 of the energy of its speed; friction only takes from it.
            const double head_m = start.position_m.z() + 0.7 * speed_mps * speed_mps / gravity_mps2;
            if (is_over) {
                EXPECT_GT(head_m, crown_m) << speed_mps;
            }
            held += is_over ? 0 : 1;
        }
    }
    EXPECT_GT(held, 6U);
}

TEST(FallOntoARoof, ReachesTheRoadBelowOnlyWhereItComesDownWithMoreEnergyThanTheRoofTakes) {
    const Slope slope = plane_slope(35.0, soft);
    const Eigen::Vector2d origin_m = slope.terrain.origin_m();
    Target road;
    road.id = "road";
    road.parts = {{Eigen::Vector2d{150.0, 5.0} - origin_m, Eigen::Vector2d{150.0, 95.0} - origin_m}};
    const auto arrivals = [&](double y_m, double capacity_j, double x_m = 105.0, double drop_m = 2.0,
                              const Eigen::Vector3d& velocity_mps = {6.0, 0.0, 1.0}) {
        Target covered = with_bounds(road);
        const auto corner = [&](double x, double y) {
            return Eigen::Vector2d{Eigen::Vector2d{x, y} - origin_m};
        };
        covered.roofs = {{{corner(145.0, 40.0), corner(155.0, 40.0), corner(155.0, 60.0), corner(145.0, 60.0),
                           corner(145.0, 40.0)},
                          capacity_j}};
        const std::vector<Target> targets{covered};
        Footprint footprint{slope.terrain, {}, targets};
        const RockStart start = start_at(slope, x_m, y_m, drop_m, velocity_mps);
        footprint.begin(start, false);
        FallScratch scratch;
        footprint.finish(
            fall(slope, Obstacles{}, deterministic_law(), {1, 0, 0, 0}, start, scratch, footprint));
        return std::vector<TargetArrival>{footprint.arrivals().begin(), footprint.arrivals().end()};
    };
    const auto beside = arrivals(20.0, 1e12);
    ASSERT_EQ(beside.size(), 1U);
    EXPECT_TRUE(arrivals(50.0, 1e12).empty());
    bool was_held = false;
    for (double capacity_j = 1.0; capacity_j < 1e8; capacity_j *= 1.5) {
        const auto met = arrivals(50.0, capacity_j);
        EXPECT_FALSE(was_held && !met.empty()) << "a stronger roof holds what a weaker one held";
        was_held = met.empty();
        if (!met.empty()) {
            EXPECT_GT(static_cast<double>(met[0].arrival.energy_j), capacity_j);
            EXPECT_GT(met[0].arrival.x_m + origin_m.x(), 144.9);
        }
    }
    EXPECT_TRUE(was_held);
    // Dropped from 30 m onto the roof above the road: what counts is the impact, not what the rock still has
    // where its way crosses the road.
    const auto dropped = arrivals(50.0, 1.0, 147.0, 30.0, {0.01, 0.0, 0.0});
    ASSERT_EQ(dropped.size(), 1U);
    const double impact_j = static_cast<double>(dropped[0].arrival.energy_j);
    const auto softer = arrivals(20.0, 1e12, 147.0, 30.0, {0.01, 0.0, 0.0});
    ASSERT_EQ(softer.size(), 1U);
    EXPECT_LT(static_cast<double>(softer[0].arrival.energy_j), 0.9 * impact_j);
    EXPECT_EQ(arrivals(50.0, 0.999 * impact_j, 147.0, 30.0, {0.01, 0.0, 0.0}).size(), 1U);
    EXPECT_TRUE(arrivals(50.0, 1.001 * impact_j, 147.0, 30.0, {0.01, 0.0, 0.0}).empty());
    EXPECT_EQ(arrivals(39.0, 1e12).size(), 1U) << "beside the roof, and its side does not count twice";
}

}  // namespace
}  // namespace rockfall::work_falls_test
