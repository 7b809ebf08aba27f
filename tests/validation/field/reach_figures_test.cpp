#include "validation/engine/field/reach_figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "config/grid/raster.hpp"
#include "rockfall/terrain/mesh.hpp"

namespace coupling::validation::reach_figures_test {
namespace {

/// A cliff of 100 m from x = 100 to 150 m, level ground on both sides; its origin is not 0.
rockfall::Terrain cliff() {
    config::Raster<double> heights{{100, 20, 5000.0, 8000.0, 5.0, 5.0}};
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        const double x_m = heights.frame.x_centre_m(heights.frame.cell_of(i).column) - 5000.0;
        heights.values[i] = 600.0 - 2.0 * std::clamp(x_m - 100.0, 0.0, 50.0);
    }
    return rockfall::triangulate(heights, 0.0);
}

observed::SimulatedStop stop_at(double x_m, bool left = false) {
    return {{5110.0, 8050.0}, {5000.0 + x_m, 8050.0}, 0, left};
}

TEST(ReachFigures, CountStopsBelowTheLeastShadowAngleOfThoseThatStopped) {
    // Falls of 80 m; the foot of the cliff lies at 150 m, where the slope over 10 m is still 45 degrees.
    const std::vector<observed::SimulatedStop> stops{stop_at(170.0), stop_at(180.0), stop_at(400.0),
                                                     stop_at(120.0), stop_at(499.0, true)};
    const ReachSample sample = reach_sample_of(cliff(), stops);
    EXPECT_EQ(sample.rocks, 5U);
    EXPECT_EQ(sample.left, 1U);
    ASSERT_EQ(sample.reach_deg.size(), 3U) << "the fall of 20 m onto the cliff is too short";
    EXPECT_NEAR(sample.reach_deg[0], 53.1301, 1e-3);
    ASSERT_EQ(sample.shadow_deg.size(), 3U);
    EXPECT_LT(sample.shadow_deg[2], 5.0);
    Outcome outcome;
    take_reach_figures("a", sample, outcome);
    EXPECT_DOUBLE_EQ(outcome.values.at("left_percent:a"), 20.0);
    EXPECT_NEAR(outcome.values.at("reach_angle_mean_deg:a"),
                (sample.reach_deg[0] + sample.reach_deg[1] + sample.reach_deg[2]) / 3.0, 1e-12);
    EXPECT_DOUBLE_EQ(outcome.values.at("shadow_below_27.5_percent:a"), 100.0);
    EXPECT_EQ(reach_row("a", sample).size(), reach_table().head.size());
}

TEST(ReachFigures, AreNamedAndLeftOutOfAnEmptySample) {
    Comparison comparison;
    name_reach_figures("a", "meaning", comparison);
    EXPECT_EQ(comparison.figures.size(), 4U);
    Outcome outcome;
    take_reach_figures("a", {{30.0, 40.0}, {20.0, 28.0, 30.0, 35.0}, 10, 1}, outcome);
    EXPECT_EQ(outcome.values.size(), 4U);
    EXPECT_DOUBLE_EQ(outcome.values.at("shadow_below_27.5_percent:a"), 25.0);
    for (const auto& [name, value] : outcome.values) {
        EXPECT_FALSE(comparison.figure(name).name.empty()) << name;
    }
    Outcome nothing;
    take_reach_figures("a", reach_sample_of(cliff(), std::vector{stop_at(300.0, true)}), nothing);
    EXPECT_EQ(nothing.values.size(), 1U);
    EXPECT_DOUBLE_EQ(nothing.values.at("left_percent:a"), 100.0);
}

}  // namespace
}  // namespace coupling::validation::reach_figures_test
