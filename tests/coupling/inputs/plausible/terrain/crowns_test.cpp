#include "coupling/inputs/plausible/terrain/crowns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace coupling::plausible::terrain::crowns_test {
namespace {

/// An even slope of 35 degrees with round crowns of half the given share of the height of their trees.
config::Raster<double> slope_with_crowns(const std::vector<ListedTree>& trees, double share) {
    config::Raster<double> heights{{.columns = 100, .rows = 100, .x_west_m = 5000.0, .y_south_m = 300.0}};
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        const config::Cell cell = heights.frame.cell_of(i);
        const double x_m = heights.frame.x_centre_m(cell.column);
        const double y_m = heights.frame.y_centre_m(cell.row);
        double crown_m = 0.0;
        for (const ListedTree& tree : trees) {
            const double away_m = std::hypot(x_m - tree.x_m, y_m - tree.y_m);
            crown_m = std::max(crown_m, share * tree.height_m * (1.0 - away_m / 3.0));
        }
        heights.values[i] = 900.0 + 0.7 * x_m - 3500.0 + crown_m;
    }
    return heights;
}

std::vector<ListedTree> trees_in_rows() {
    std::vector<ListedTree> trees;
    for (int row = 0; row < 6; ++row) {
        for (int column = 0; column < 6; ++column) {
            trees.push_back({5011.0 + 15.0 * column, 311.0 + 15.0 * row, 12.0 + row + column});
        }
    }
    return trees;
}

TEST(Crowns, StandOnBareGroundUnseen) {
    const std::vector<ListedTree> trees = trees_in_rows();
    const Bumps bumps = bumps_at(slope_with_crowns(trees, 0.0), trees);
    EXPECT_EQ(bumps.trees, 36U);
    EXPECT_NEAR(bumps.median_m, 0.0, 0.5);  // half a cell of the slope
    EXPECT_FALSE(judge_crowns(slope_with_crowns(trees, 0.0), trees));
}

TEST(Crowns, AreSeenWhereTheTreesStand) {
    const std::vector<ListedTree> trees = trees_in_rows();
    const std::optional<Finding> finding = judge_crowns(slope_with_crowns(trees, 0.8), trees);
    ASSERT_TRUE(finding);
    EXPECT_TRUE(finding->is_error);
    const std::optional<Finding> low = judge_crowns(slope_with_crowns(trees, 0.12), trees);
    ASSERT_TRUE(low);
    EXPECT_FALSE(low->is_error);
}

TEST(Crowns, NeedTwentyTallTrees) {
    std::vector<ListedTree> trees = trees_in_rows();
    const config::Raster<double> crowns = slope_with_crowns(trees, 0.8);
    trees.resize(19);
    EXPECT_FALSE(judge_crowns(crowns, trees));
    std::vector<ListedTree> small = trees_in_rows();
    for (ListedTree& tree : small) {
        tree.height_m = 5.0;
    }
    EXPECT_FALSE(judge_crowns(crowns, small));
}

}  // namespace
}  // namespace coupling::plausible::terrain::crowns_test
