// Run-out against noise and cell size of the DEM, on the geometry of the bench slope: a plane of 38 degrees,
// 350 m long, above a flat floor. The rocks and their random numbers are the same in every run.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "config/random/distributions.hpp"
#include "rockfall/parameters.hpp"
#include "rockfall/terrain/contact_zone.hpp"
#include "tests/rockfall/slopes.hpp"

namespace rockfall::noise_test {
namespace {

using testing::deterministic_law;
using testing::heights_of;
using testing::slope_over;
using testing::start_at;

constexpr double slope_length_m = 350.0;
constexpr double floor_length_m = 150.0;
constexpr double width_m = 300.0;
constexpr double diameter_m = 0.95;
constexpr int rocks = 1500;

/// A motion model, and the slope on which its rocks run out by the noise: those of PiR3D stop on the slope by
/// friction.
struct Scene {
    MotionModel model;
    double slope_deg;
    double friction;
    double tolerance;  ///< the same rocks fall, so chance is far below that of a mean of 1500 rocks (1.9 %)
};
const Scene scenes[] = {{motion_model<picus::Model>, 38.0, 0.6, 0.01},
                        {motion_model<pir3d::Model>, 34.0, 0.7, 0.03}};

config::Raster<double> noisy_bench(const Scene& scene, double cell_m, double noise_m) {
    const double tangent = std::tan(config::Angle::from_degrees(scene.slope_deg).in_radians());
    const config::GridFrame frame{static_cast<int>((slope_length_m + floor_length_m) / cell_m),
                                  static_cast<int>(width_m / cell_m),
                                  0.0,
                                  0.0,
                                  cell_m,
                                  cell_m};
    std::uint64_t cell = 0;
    return heights_of(frame, [&](double x, double) {
        const config::RandomStream stream{{5, 0, 0, cell++}, config::Purpose::test};
        return std::max(0.0, slope_length_m - x) * tangent +
               noise_m * config::normal(stream.uniforms_of(0)[0], 0.0, 1.0);
    });
}

Slope bare_slope(const Scene& scene, const config::Raster<double>& heights) {
    Slope slope = slope_over(heights, {0.30, 0.75}, 0.02);
    slope.types.front().soil = testing::test_soil(scene.friction);
    return slope;
}

Slope felt_slope(const Scene& scene, const config::Raster<double>& heights) {
    const ContactLaw law = Parameters{}.ground.contact_law(diameter_m);
    return bare_slope(scene, contact_zone(heights, law, HeightNoise{heights}));
}

/// Mean run-out of rocks that each impact stops with 2 %: it depends on the number of impacts per metre, that
/// is on noise.
double mean_run_out_m(const Slope& slope, MotionModel model) {
    FallLaw law;
    law.motion.model = model;
    law.tree.deviation = deterministic_law().tree.deviation;
    FallScratch scratch;
    NoObserver nobody;
    double sum_m = 0.0;
    for (std::uint64_t rock = 0; rock < rocks; ++rock) {
        const config::RandomStream stream{{6, 0, 0, rock}, config::Purpose::test};
        const RockStart start = start_at(slope, 15.0, 100.0 + 100.0 * stream.uniforms_of(0)[0], 1.5,
                                         {2.598, 0.0, -1.5}, diameter_m, rock);
        const FallEnd end = fall(slope, Obstacles{}, law, {1, 0, 0, rock}, start, scratch, nobody);
        sum_m += (end.position_m - start.position_m).head<2>().norm();
    }
    return sum_m / rocks;
}

struct Case {
    double cell_m;
    double noise_m;
};

class RunOutOnNoisyGround : public ::testing::TestWithParam<Case> {};

TEST_P(RunOutOnNoisyGround, IsThatOfSmoothGroundWithTheContactZone) {
    const auto [cell_m, noise_m] = GetParam();
    for (const Scene& scene : scenes) {
        const double smooth_m = mean_run_out_m(bare_slope(scene, noisy_bench(scene, 2.5, 0.0)), scene.model);
        const double felt_m =
            mean_run_out_m(felt_slope(scene, noisy_bench(scene, cell_m, noise_m)), scene.model);
        std::printf("%s, cell %4.1f m, noise %.1f m: run-out %.1f m with the contact zone, %.1f m smooth\n",
                    std::string{description_of(scene.model).name}.c_str(), cell_m, noise_m, felt_m, smooth_m);
        EXPECT_NEAR(felt_m / smooth_m, 1.0, scene.tolerance) << description_of(scene.model).name;
    }
}

INSTANTIATE_TEST_SUITE_P(CellsAndNoise, RunOutOnNoisyGround,
                         ::testing::Values(Case{1.0, 0.0}, Case{1.0, 0.1}, Case{1.0, 0.3}, Case{1.0, 0.5},
                                           Case{2.0, 0.0}, Case{2.0, 0.2}, Case{2.0, 0.5}, Case{5.0, 0.0},
                                           Case{5.0, 0.1}, Case{5.0, 0.3}, Case{5.0, 0.5}, Case{10.0, 0.3}));

TEST(RunOutOnNoisyGround, DependsOnTheNoiseWithoutTheContactZone) {
    const auto bare_share = [](const Scene& scene, double cell_m, double noise_m) {
        const auto run_out_m = [&](double with_m) {
            return mean_run_out_m(bare_slope(scene, noisy_bench(scene, cell_m, with_m)), scene.model);
        };
        return run_out_m(noise_m) / run_out_m(0.0);
    };
    EXPECT_LT(bare_share(scenes[0], 1.0, 0.3), 0.85);
    EXPECT_LT(bare_share(scenes[1], 1.0, 0.3), 0.85);
    EXPECT_LT(bare_share(scenes[1], 5.0, 0.5), 0.85);
}

}  // namespace
}  // namespace rockfall::noise_test
