// Roughness of the ground below the cells of the terrain, and scars.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "rockfall/motion/rigid/bumps.hpp"
#include "rockfall/motion/rigid/scarring.hpp"
#include "tests/rockfall/motion/rigid/scene.hpp"
#include "tests/rockfall/motion/rigid/whole_fall.hpp"

namespace rockfall::rigid::testing {
namespace {

using Eigen::Vector2d;

Law rough_law(double roughness_m) {
    Law law = law_of(0.6, 0.2);
    law.roughness_m = roughness_m;
    law.rolling_resistance = 0.03;
    return law;
}

std::vector<double> node_heights_m(const Slope& slope, const Law& law, double diameter_m) {
    const Bumps bumps{slope, law, diameter_m, {.seed = 1, .id = 7}};
    Bumps::Nodes nodes;
    bumps.find_nodes({100.0, 100.0}, 40.0, slope.terrain.locate(100.0, 100.0).value(), nodes);
    return nodes.heights_m;
}

double deviation(const std::vector<double>& values) {
    double squares = 0.0;
    for (const double value : values) {
        squares += value * value;
    }
    return std::sqrt(squares / static_cast<double>(values.size()));
}

TEST(Bumps, HaveTheDeviationOfTheGroundLessWhatCellsShow) {
    const Slope slope = plane(20.0, 200.0, 200.0, 5.0);
    const std::vector<double> heights_m = node_heights_m(slope, rough_law(0.05), 0.4);
    // The deviation of a sum of two uniforms: (kurtosis 2.4 - 1) / 4 of its square by the number of draws.
    const double expected_m = 0.05 * std::sqrt(1.0 - 0.4 / 5.0);
    const double four_sigma = 4.0 * std::sqrt(0.35 / static_cast<double>(heights_m.size()));
    EXPECT_NEAR(deviation(heights_m) / expected_m, 1.0, four_sigma);
    EXPECT_LE(std::abs(*std::max_element(heights_m.begin(), heights_m.end())), std::sqrt(6.0) * expected_m);
}

TEST(Bumps, AreAQuarterOfTheirSpacingAtMost) {
    const Slope slope = plane(20.0, 200.0, 200.0, 20.0);
    EXPECT_NEAR(deviation(node_heights_m(slope, rough_law(3.0), 0.8)) / (0.2 * std::sqrt(0.96)), 1.0, 0.03);
}

TEST(Bumps, AreNoneWhereCellsAreNoCoarserThanTheBlock) {
    const Slope slope = plane(20.0, 200.0, 200.0, 1.0);
    EXPECT_EQ(deviation(node_heights_m(slope, rough_law(0.1), 1.2)), 0.0);
}

/// Highest and lowest ground of the patch over the plane, by the vertices of its triangles.
TEST(GroundPatches, AreTheTerrainPlusBumpsWithoutGaps) {
    const Slope slope = plane(20.0, 200.0, 200.0, 5.0);
    const Law law = rough_law(0.05);
    const Bumps bumps{slope, law, 0.5, {.seed = 1, .id = 3}};
    GroundPatch patch;
    PatchMarks marks;
    config::RandomStream draw{{5, 0, 0, 0}, config::Purpose::test};
    for (int i = 0; i < 200; ++i) {
        const Vector2d centre_m{50.0 + 100.0 * draw.uniform(), 50.0 + 100.0 * draw.uniform()};
        patch.gather(slope.terrain, bumps, slope.terrain.locate(centre_m.x(), centre_m.y()).value(), centre_m,
                     0.6, marks);
        double height_m = 0.0;
        int under = 0;
        for (const NearTriangle& near : patch.triangles()) {
            if (near.outside_m({centre_m.x(), centre_m.y(), 0.0}) < 0.0) {
                ++under;
                height_m = (near.offset_m - near.normal.head<2>().dot(centre_m)) / near.normal.z();
            }
        }
        EXPECT_EQ(under, 1) << centre_m.transpose();
        EXPECT_LE(std::abs(height_m - slope.terrain.height_m(centre_m.x(), centre_m.y()).value()),
                  bumps.highest_m());
        // Facets at a common corner meet there.
        for (const NearTriangle& one : patch.triangles()) {
            for (const NearTriangle& other : patch.triangles()) {
                for (int k = 0; k < 3; ++k) {
                    for (int n = 0; n < 3; ++n) {
                        if (one.corners[k] == other.corners[n]) {
                            EXPECT_NEAR(other.gap_m(one.corners_m[k]), 0.0, 1e-7);
                        }
                    }
                }
            }
        }
    }
}

TEST(RoughGround, NeverGivesEnergy) {
    const Slope slope = plane(30.0, 200.0, 60.0, 5.0);
    const Law law = rough_law(0.06);
    for (std::uint64_t id = 0; id < 6; ++id) {
        const solids::Solid solid = id % 2 == 0 ? cube(0.4) : solids::ball_of(0.4, 2700.0);
        Body start = lying(slope, solid, 30.0, 20.3, 30.2);
        start.centre_m.z() += 1.0;
        BlockScratch scratch;
        Block block{slope,
                    law,
                    solid,
                    start,
                    slope.terrain.locate(20.3, 30.2).value(),
                    scratch,
                    Bumps{slope, law, solid.diameter_m(), {.seed = 2, .id = id}}};
        double energy_j = start.kinetic_j(solid) + start.potential_j(solid);
        const double allowed_j = 1e-5 * solid.mass_kg + 1e-9 * energy_j;
        bool on_ground = false, inside = true;
        for (int i = 0; i < 3000 && inside; ++i) {
            if (on_ground) {
                const Touchdown touchdown = block.step(law.step_s, inside);
                on_ground = touchdown.touched && touchdown.lasts;
                if (!on_ground) {
                    block.clear_overlap();
                }
            } else {
                const FreeFlight flight = block.fly();
                block.go_on(flight.duration_s);
                inside = flight.end == FlightStop::contact;
                on_ground = inside && block.strike().lasts;
            }
            const double now_j = block.body().kinetic_j(solid) + block.body().potential_j(solid);
            EXPECT_LE(now_j, energy_j + allowed_j) << "rock " << id << ", event " << i;
            energy_j = std::min(now_j, energy_j);
        }
    }
}

/// A slope with stones and hummocks of 0.08 m at each half metre, as a survey in cells of this size shows it.
Slope surveyed(double cell_m) {
    const config::GridFrame frame{
        static_cast<int>(120.0 / cell_m), static_cast<int>(30.0 / cell_m), 0.0, 0.0, cell_m, cell_m};
    return rockfall::testing::slope_over(
        rockfall::testing::heights_of(
            frame,
            [](double x_m, double y_m) {
                const auto place =
                    static_cast<std::uint64_t>(2.0 * x_m) * 1000U + static_cast<std::uint64_t>(2.0 * y_m);
                config::RandomStream draw{{.seed = 9, .id = place}, config::Purpose::test};
                return 500.0 - std::tan(radians(33.0)) * x_m + 0.28 * (draw.uniform() - 0.5);
            }),
        {0.3, 0.8});
}

/// Mean way in plan of plates that are thrown onto the class `hard`.
double mean_way_m(double cell_m, double roughness_m) {
    const Slope slope = surveyed(cell_m);
    Law law;
    law.roughness_m = roughness_m;
    const solids::Solid plate = solids::solid_of(solids::box({0.5, 0.4, 0.2}), 2700.0);
    double sum_m = 0.0;
    constexpr int rocks = 24;
    for (std::uint64_t id = 0; id < rocks; ++id) {
        config::RandomStream draw{{3, 0, 0, id}, config::Purpose::test};
        Body body;
        body.rotation.attitude =
            Eigen::Quaterniond{draw.uniform(), draw.uniform(), draw.uniform(), draw.uniform()}.normalized();
        const Vector2d at_m = Vector2d{8.0, 15.0 + draw.uniform()} - slope.terrain.origin_m();
        body.centre_m = {at_m.x(), at_m.y(), slope.terrain.height_m(at_m.x(), at_m.y()).value() + 1.0};
        body.velocity_mps = {2.0, 0.0, 0.0};
        BlockScratch scratch;
        Block block{slope,
                    law,
                    plate,
                    body,
                    slope.terrain.locate(at_m.x(), at_m.y()).value(),
                    scratch,
                    Bumps{slope, law, plate.diameter_m(), {.seed = 4, .id = id}}};
        sum_m += (moved(block, law, 6.0, false).centre_m - body.centre_m).head<2>().norm();
    }
    return sum_m / rocks;
}

TEST(RoughGround, OfAFineSurveyGivesAnotherWayThanACoarseOne) {
    const double fine_m = mean_way_m(0.5, 0.0), coarse_m = mean_way_m(5.0, 0.0);
    EXPECT_GT(std::abs(fine_m - coarse_m), 0.2 * coarse_m) << fine_m << " and " << coarse_m << " m";
    // What the coarse survey hides, given as roughness of the ground, brings half of the difference or more.
    const double helped_m = mean_way_m(5.0, 0.08);
    EXPECT_LT(std::abs(fine_m - helped_m), 0.5 * std::abs(fine_m - coarse_m))
        << fine_m << ", " << coarse_m << " and " << helped_m << " m";
}

TEST(Scars, TakeTheSameShareOfTheSpeedAtAnySpeedOnEachMetre) {
    const ScarLaw law;
    const Scar scar = scar_of(law, 1000.0, 0.9, 1000.0, 5.0, 0.0);
    EXPECT_NEAR(scar.depth_m, scar_depth_m(1000.0, 1000.0, 5.0), 1e-15);
    EXPECT_NEAR(scar.left_m, chord_m(0.9, scar.depth_m), 1e-15);
    EXPECT_NEAR(scar.drag_pm,
                0.5 * law.drag_factor * law.soil_density_kgpm3 * scar.depth_m * scar.left_m / 1000.0, 1e-12);
    EXPECT_GT(scar_of(law, 1000.0, 0.9, 1000.0, 5.0, 0.3).drag_pm, scar.drag_pm);
}

TEST(Scars, BrakeABallThatLandsButNotOneThatRolls) {
    const Slope flat = plane(0.0, 200.0, 20.0);
    Law law = law_of(0.6, 0.0);
    law.soil_strength_kpa = 1000.0;
    const solids::Solid ball = solids::ball_of(0.8, 2700.0);
    const auto speed_mps = [&](double fall_m, const Law& with) {
        Body body = lying(flat, ball, 0.0, 20.0, 10.0);
        body.centre_m.z() += fall_m;
        body.velocity_mps = {7.0, 0.0, 0.0};
        body.rotation.momentum_nms = ball.inertia_kgm2.cwiseProduct(body.rotation.attitude.conjugate() *
                                                                    Vector3d{0.0, 7.0 / 0.4, 0.0});
        BlockScratch scratch;
        Block block{flat, with, ball, body, flat.terrain.locate(20.0, 10.0).value(), scratch};
        return moved(block, with, 1.5, fall_m <= 0.0).velocity_mps.x();
    };
    Law bare = law;
    bare.scar.on = false;
    EXPECT_NEAR(speed_mps(0.0, law), 7.0, 1e-9);
    EXPECT_NEAR(speed_mps(1.0, bare), 7.0, 1e-6);
    // Through one scar, then rolling on without drag. Friction gives back two sevenths of what it took.
    const Scar scar =
        scar_of(law.scar, ball.mass_kg, 0.8, 1000.0, std::sqrt(2.0 * config::gravity_mps2), 0.0);
    const double after_scar = std::exp(-scar.drag_pm * scar.left_m);
    EXPECT_NEAR(speed_mps(1.0, law) / 7.0, after_scar + 2.0 / 7.0 * (1.0 - after_scar), 0.02);
    EXPECT_LT(speed_mps(1.0, law), 6.8);
}

}  // namespace
}  // namespace rockfall::rigid::testing
