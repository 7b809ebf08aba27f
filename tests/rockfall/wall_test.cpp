// Run-out behind a wall: a slope of 38 degrees, a wall, a platform, and the slope again. The contact zone
// must not round the wall, so that rocks go as far as on the exact triangles. The rocks and their random
// numbers are the same in both.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "config/random/distributions.hpp"
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

constexpr int rocks = 1000;
constexpr double wall_x_m = 40.0;
constexpr double diameter_m = 0.95;
constexpr double width_m = 40.0;

struct Wall {
    double height_m;
    double platform_m;
};

/// A survey of the wall.
struct Survey {
    double cell_m;
    double noise_m;
};

std::ostream& operator<<(std::ostream& out, const Survey& survey) {
    return out << "cells of " << survey.cell_m << " m, noise of " << survey.noise_m << " m";
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

config::Raster<double> surveyed(const Wall& wall, const Survey& survey) {
    // Points at whole metres, so that the triangles of a grid without noise are those of the profile.
    const config::GridFrame frame{static_cast<int>(320.0 / survey.cell_m),
                                  static_cast<int>(width_m / survey.cell_m),
                                  -0.5 * survey.cell_m,
                                  0.0,
                                  survey.cell_m,
                                  survey.cell_m};
    std::uint64_t cell = 0;
    return heights_of(frame, [&](double x_m, double) {
        const config::RandomStream stream{{5, 0, 0, cell++}, config::Purpose::test};
        return height_at_m(wall, x_m) + survey.noise_m * config::normal(stream.uniforms_of(0)[0], 0.0, 1.0);
    });
}

struct RunOut {
    double mean_m;
    double error_m;  ///< standard error of the mean
};

RunOut run_out(const Slope& slope, MotionModel model) {
    FallLaw law;
    law.motion.model = model;
    law.tree.deviation = deterministic_law().tree.deviation;
    FallScratch scratch;
    NoObserver nobody;
    double sum_m = 0.0;
    double squares_m2 = 0.0;
    for (std::uint64_t rock = 0; rock < rocks; ++rock) {
        const config::RandomStream stream{{7, 0, 0, rock}, config::Purpose::test};
        const double x_m = 10.0 + 25.0 * stream.uniforms_of(0)[0];
        const RockStart start =
            start_at(slope, x_m, 0.5 * width_m, 1.5, {2.598, 0.0, -1.5}, diameter_m, rock);
        const FallEnd end = fall(slope, Obstacles{}, law, {1, 0, 0, rock}, start, scratch, nobody);
        const double run_out_m = end.position_m.x() - start.position_m.x();
        sum_m += run_out_m;
        squares_m2 += run_out_m * run_out_m;
    }
    const double mean_m = sum_m / rocks;
    return {mean_m, std::sqrt((squares_m2 / rocks - mean_m * mean_m) / rocks)};
}

constexpr Wall walls[] = {{6.0, 5.0},   {6.0, 10.0}, {6.0, 15.0},  {12.0, 5.0}, {12.0, 10.0},
                          {12.0, 15.0}, {20.0, 5.0}, {20.0, 10.0}, {20.0, 15.0}};

class RunOutBehindAWall : public ::testing::TestWithParam<Survey> {};

TEST_P(RunOutBehindAWall, IsThatOnTheExactTriangles) {
    for (const Wall& wall : walls) {
        const config::Raster<double> heights = surveyed(wall, GetParam());
        const Slope exact = slope_over(surveyed(wall, {1.0, 0.0}), {0.30, 0.75}, 0.02);
        const ContactLaw law = GroundLaw{}.contact_law(diameter_m);
        const Slope felt = slope_over(contact_zone(heights, law, HeightNoise{heights}), {0.30, 0.75}, 0.02);
        for (const MotionModel model : {motion_model<picus::Model>, motion_model<pir3d::Model>}) {
            const RunOut on_exact = run_out(exact, model);
            const RunOut on_felt = run_out(felt, model);
            // Rocks on the two soon go different ways: two standard errors of the difference.
            const double chance_m = 2.0 * std::hypot(on_exact.error_m, on_felt.error_m);
            std::printf("%s, wall of %.0f m, platform of %.0f m: run-out %.1f m, %.1f m on the triangles\n",
                        std::string{description_of(model).name}.c_str(), wall.height_m, wall.platform_m,
                        on_felt.mean_m, on_exact.mean_m);
            EXPECT_NEAR(on_felt.mean_m, on_exact.mean_m, 0.05 * on_exact.mean_m + chance_m)
                << description_of(model).name << ", wall of " << wall.height_m << " m, platform of "
                << wall.platform_m << " m";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Surveys, RunOutBehindAWall,
                         ::testing::Values(Survey{0.5, 0.1}, Survey{1.0, 0.0}, Survey{1.0, 0.2}));
INSTANTIATE_TEST_SUITE_P(LongSurveys, RunOutBehindAWall,
                         ::testing::Values(Survey{0.25, 0.0}, Survey{0.25, 0.1}, Survey{0.25, 0.2},
                                           Survey{0.5, 0.0}, Survey{0.5, 0.2}, Survey{1.0, 0.1}));

}  // namespace
}  // namespace rockfall::wall_test
