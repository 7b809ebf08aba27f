// Run-out behind a wall: a slope of 38 degrees, a wall, a platform, and the slope again. The contact zone
// must not round the wall, so that rocks go as far as on the exact triangles. The rocks and their random
// numbers are the same in both.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "config/random/stream.hpp"
#include "rockfall/parameters.hpp"
#include "rockfall/slope/profile_strip.hpp"
#include "rockfall/terrain/contact_zone.hpp"
#include "tests/rockfall/slopes.hpp"

namespace rockfall::wall_test {
namespace {

using testing::deterministic_law;
using testing::heights_of;
using testing::slope_over;
using testing::start_at;

constexpr int rocks = 4000;
constexpr double wall_x_m = 40.0;

struct Wall {
    double height_m;
    double platform_m;
};

std::ostream& operator<<(std::ostream& out, const Wall& wall) {
    return out << wall.height_m << " m over " << wall.platform_m << " m";
}

/// Height at a distance: 40 m of slope, the wall within 1 m, the platform, 120 m of slope, a flat floor.
double height_at_m(const Wall& wall, double x_m) {
    const double tangent = std::tan(config::Angle::from_degrees(38.0).in_radians());
    const double foot_x_m = wall_x_m + 1.0;
    const double lower_x_m = foot_x_m + wall.platform_m;
    const double floor_x_m = lower_x_m + 120.0;
    const double platform_m = 120.0 * tangent;
    if (x_m >= floor_x_m) {
        return 0.0;
    }
    if (x_m >= lower_x_m) {
        return (floor_x_m - x_m) * tangent;
    }
    if (x_m >= foot_x_m) {
        return platform_m;
    }
    if (x_m >= wall_x_m) {
        return platform_m + (foot_x_m - x_m) * wall.height_m;
    }
    return platform_m + wall.height_m + (wall_x_m - x_m) * tangent;
}

config::Raster<double> grid_of(const Wall& wall) {
    // Points at whole metres, so that the triangles of the grid are those of the profile.
    return heights_of({320, 60, -0.5, 0.0, 1.0, 1.0},
                      [&](double x_m, double) { return height_at_m(wall, x_m); });
}

double mean_run_out_m(const Slope& slope, MotionModel model) {
    FallLaw law;
    law.motion.model = model;
    law.tree.deviation = deterministic_law().tree.deviation;
    FallScratch scratch;
    NoObserver nobody;
    double sum_m = 0.0;
    for (std::uint64_t rock = 0; rock < rocks; ++rock) {
        const config::RandomStream stream{{7, 0, 0, rock}, config::Purpose::test};
        const double x_m = 10.0 + 25.0 * stream.uniforms_of(0)[0];
        const RockStart start = start_at(slope, x_m, 30.0, 1.5, {2.598, 0.0, -1.5}, 0.95, rock);
        const FallEnd end = fall(slope, Obstacles{}, law, {1, 0, 0, rock}, start, scratch, nobody);
        sum_m += end.position_m.x() - start.position_m.x();
    }
    return sum_m / rocks;
}

class RunOutBehindAWall : public ::testing::TestWithParam<Wall> {};

TEST_P(RunOutBehindAWall, IsThatOnTheExactTriangles) {
    const config::Raster<double> exact = grid_of(GetParam());
    const config::Raster<double> felt =
        contact_zone(exact, GroundLaw{}.contact_law(0.95), HeightNoise{exact});
    for (const MotionModel model : {motion_model<picus::Model>, motion_model<pir3d::Model>}) {
        const double exact_m = mean_run_out_m(slope_over(exact, {0.30, 0.75}, 0.02), model);
        const double felt_m = mean_run_out_m(slope_over(felt, {0.30, 0.75}, 0.02), model);
        std::printf(
            "%s, wall of %.0f m, platform of %.0f m: run-out %.1f m with the contact zone, %.1f m on the "
            "triangles\n",
            std::string{description_of(model).name}.c_str(), GetParam().height_m, GetParam().platform_m,
            felt_m, exact_m);
        EXPECT_NEAR(felt_m / exact_m, 1.0, 0.05);
    }
}

INSTANTIATE_TEST_SUITE_P(HeightsAndPlatforms, RunOutBehindAWall,
                         ::testing::Values(Wall{6.0, 5.0}, Wall{6.0, 10.0}, Wall{6.0, 15.0}, Wall{12.0, 5.0},
                                           Wall{12.0, 10.0}, Wall{12.0, 15.0}, Wall{20.0, 5.0},
                                           Wall{20.0, 10.0}, Wall{20.0, 15.0}));

}  // namespace
}  // namespace rockfall::wall_test
