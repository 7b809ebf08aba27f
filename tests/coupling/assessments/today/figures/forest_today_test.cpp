#include "coupling/assessments/today/figures/forest_today.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "coupling/inputs/scenario/scenario.hpp"
#include "tests/coupling/results/small_run.hpp"

namespace coupling::forest_today_test {
namespace {

using small_runs::SmallRun;

/// Rocks cross all cells of the square of 80 m.
SmallRun crossed_run() {
    SmallRun run;
    run.fall(40);
    for (int row = 0; row < 8; ++row) {
        for (int column = 0; column < 8; ++column) {
            run.pass(rockfall::Cover::bare, {column, row}, 1000.0F, 5.0F, 0.5F);
        }
    }
    return run;
}

TEST(ForestToday, CountsStemsWhereRocksCross) {
    const SmallRun run = crossed_run();
    const auto found = forest_today(run.results());
    ASSERT_TRUE(found);
    // Cells of 10 m whose centre lies within 30 m of one of three stems in a row: by hand.
    int cells = 0;
    for (int row = 0; row < 8; ++row) {
        for (int column = 0; column < 8; ++column) {
            const double x_m = 10.0 * column + 5.0;
            const double y_m = 10.0 * row + 5.0;
            cells += std::hypot(x_m - 25.0, y_m - 45.0) <= 30.0 ||
                             std::hypot(x_m - 35.0, y_m - 45.0) <= 30.0 ||
                             std::hypot(x_m - 45.0, y_m - 45.0) <= 30.0
                         ? 1
                         : 0;
        }
    }
    EXPECT_NEAR(found->area_ha, 0.01 * cells, 1e-12);
    EXPECT_EQ(found->stems, 3U);
    EXPECT_NEAR(found->stems_pha, 3.0 / found->area_ha, 1e-9);
    EXPECT_NEAR(found->stems_from_12_cm_pha, 3.0 / found->area_ha, 1e-9);
    const double squares_m2 = 0.325 * 0.325 + 0.61 * 0.61 + 0.12 * 0.12;
    EXPECT_NEAR(found->basal_area_m2pha, 0.25 * std::numbers::pi * squares_m2 / found->area_ha, 1e-9);
    EXPECT_NEAR(found->mean_dbh_cm, 100.0 * std::sqrt(squares_m2 / 3.0), 1e-9);
    ASSERT_EQ(found->species.size(), 3U);
    EXPECT_EQ(found->species[0].code, "ABAL") << "the thickest";
    EXPECT_EQ(found->gaps.patches, static_cast<std::uint32_t>(cells));
    EXPECT_EQ(found->gaps.open_patches, static_cast<std::uint32_t>(cells - 3));
}

TEST(ForestToday, MeasuresGapsDownTheSlopeAlongTheGround) {
    const SmallRun run = crossed_run();
    const auto found = forest_today(run.results());
    ASSERT_TRUE(found);
    // Columns of open cells down a slope of 0.75: along the ground a cell is 12.5 m long.
    const double cells = found->gaps.max_m / 12.5;
    EXPECT_NEAR(cells, std::round(cells), 1e-6);
    EXPECT_GE(cells, 3.0);
}

TEST(ForestToday, IsHeldAgainstTheProfileOfItsBlocks) {
    SmallRun run = crossed_run();
    run.scenario->release.diameter_m = 0.3;
    auto found = forest_today(run.results());
    ASSERT_TRUE(found && found->profile);
    EXPECT_EQ(found->profile->dbh_from_cm, 12.0);
    EXPECT_NEAR(found->check.stems_pha, found->stems_from_12_cm_pha, 1e-9);
    EXPECT_FALSE(found->check.has_stems) << "three stems on a third of a hectare";
    run.scenario->release.diameter_m = 3.0;
    found = forest_today(run.results());
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->profile) << "larger than NaiS speaks of";
}

TEST(ForestToday, NeedsLivingStemsWhereRocksCross) {
    SmallRun run;
    EXPECT_FALSE(forest_today(run.results())) << "no rock crosses anything";
    run = crossed_run();
    for (TreeRecord& tree : run.site.trees) {
        tree.stem.strength = 0.5;
    }
    EXPECT_FALSE(forest_today(run.results())) << "all dead";
    run.site.trees.clear();
    EXPECT_FALSE(forest_today(run.results()));
}

}  // namespace
}  // namespace coupling::forest_today_test
