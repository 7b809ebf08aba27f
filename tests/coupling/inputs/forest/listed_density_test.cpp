#include "coupling/inputs/forest/listed_density.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace coupling::listed_density_test {
namespace {

TreeRecord tree_at(double x_m, double y_m, double dbh_cm) {
    TreeRecord tree;
    tree.stem.x_m = x_m;
    tree.stem.y_m = y_m;
    tree.stem.dbh_cm = dbh_cm;
    return tree;
}

/// Two cells of 20 m are 0.08 ha; stems of 20 cm have 0.031416 m2 each.
TEST(ListedDensity, IsPerHectareOfTheCellsWithATree) {
    const std::vector<TreeRecord> trees{tree_at(1.0, 1.0, 20.0), tree_at(19.0, 19.0, 20.0),
                                        tree_at(-1.0, 1.0, 20.0)};
    const ListedDensity density = listed_density(trees);
    EXPECT_NEAR(density.wooded_ha, 0.08, 1e-12);
    EXPECT_NEAR(density.stems_pha, 37.5, 1e-9);
    EXPECT_NEAR(density.basal_area_m2pha, 3.0 * 0.0314159265 / 0.08, 1e-6);
}

}  // namespace
}  // namespace coupling::listed_density_test
