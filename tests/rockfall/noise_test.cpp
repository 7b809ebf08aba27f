// Run-out against noise and cell size of the DEM, on the geometry of the bench slope: a plane of 38 degrees,
// 350 m long, above a flat floor. The rocks and their random numbers are the same in every run.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

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
constexpr int rocks = 1500;

config::Raster<double> noisy_bench(double cell_m, double noise_m) {
    const double tangent = std::tan(config::Angle::from_degrees(38.0).in_radians());
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

/// Mean run-out of rocks that each impact stops with 2 %: it hangs on the number of impacts per metre, that
/// is on noise.
double mean_run_out_m(double cell_m, double noise_m, double support_m) {
    const Slope slope =
        slope_over(contact_zone(noisy_bench(cell_m, noise_m), support_m, 1.0), {0.30, 0.75}, 0.02);
    FallLaw law;
    law.tree.deviation = deterministic_law().tree.deviation;
    FallScratch scratch;
    NoObserver nobody;
    double sum_m = 0.0;
    for (std::uint64_t rock = 0; rock < rocks; ++rock) {
        const config::RandomStream stream{{6, 0, 0, rock}, config::Purpose::test};
        const RockStart start = start_at(slope, 15.0, 100.0 + 100.0 * stream.uniforms_of(0)[0], 1.5,
                                         {2.598, 0.0, -1.5}, 0.95, rock);
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
    const double support_m = Parameters{}.ground.contact_support_m;
    static const double smooth_m = mean_run_out_m(2.5, 0.0, 0.0);
    const double with_zone_m = mean_run_out_m(cell_m, noise_m, support_m);
    const double without_m = mean_run_out_m(cell_m, noise_m, 0.0);
    std::printf("cell %4.1f m, noise %.1f m: run-out %.1f m with the contact zone, %.1f m without\n", cell_m,
                noise_m, with_zone_m, without_m);
    // The same rocks fall, so the chance in the difference is far below that of a mean of 1500 rocks (1.9 %).
    EXPECT_NEAR(with_zone_m / smooth_m, 1.0, 0.025);
}

INSTANTIATE_TEST_SUITE_P(CellsAndNoise, RunOutOnNoisyGround,
                         ::testing::Values(Case{1.0, 0.0}, Case{1.0, 0.1}, Case{1.0, 0.3}, Case{2.5, 0.0},
                                           Case{2.5, 0.1}, Case{2.5, 0.3}, Case{5.0, 0.0}, Case{5.0, 0.1},
                                           Case{5.0, 0.3}, Case{10.0, 0.0}, Case{10.0, 0.1},
                                           Case{10.0, 0.3}));

TEST(RunOutOnNoisyGround, HangsOnTheNoiseWithoutTheContactZone) {
    const double smooth_m = mean_run_out_m(1.0, 0.0, 0.0);
    EXPECT_LT(mean_run_out_m(1.0, 0.3, 0.0) / smooth_m, 0.85);
}

}  // namespace
}  // namespace rockfall::noise_test
