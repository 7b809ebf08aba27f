#include "forest/disturbance/beetle_hosts.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "forest/stand/allometry.hpp"
#include "tests/forest/small_forest.hpp"

namespace forest::beetle_hosts_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const SpeciesId spruce = *table.find("piab");
const SpeciesId fir = *table.find("abal");

TEST(BeetleSuccess, FollowsThePublishedTerms) {
    EXPECT_NEAR(success_by_age(70.0), 0.5, 1e-12);
    EXPECT_NEAR(success_by_age(100.0), 1.0 / (1.0 + std::exp(-3.27)), 1e-12);
    EXPECT_NEAR(success_by_share(0.375), 0.08 + 0.92 / std::pow(1.2675, 3.33), 1e-12);
    EXPECT_GT(success_by_share(1.0), 0.98);
    EXPECT_LT(success_by_share(0.05), 0.12);
    EXPECT_DOUBLE_EQ(success_by_stress(0.0), 0.15);
    EXPECT_DOUBLE_EQ(success_by_stress(1.0), 1.0);
}

TEST(BeetleSuccess, RisesWithDroughtPoorGrowthAgeAndTheShareOfSpruce) {
    Tree tree = new_tree(table[spruce], spruce, 5.0, 5.0, 30.0, 25.0, 90.0);
    constexpr double moist = 0.0;
    constexpr double dry = 0.4;
    const BeetleHosts pure{0.3, 1.0};
    const double usual = colonisation_success(tree, moist, pure);
    const double in_drought = colonisation_success(tree, dry, pure);
    EXPECT_GT(in_drought, usual);
    EXPECT_LT(colonisation_success(tree, moist, {0.3, 0.2}), 0.5 * usual);
    tree.stress_years = 1;
    EXPECT_GT(colonisation_success(tree, moist, pure), in_drought) << "a year of poor growth";
    tree.stress_years = 0;
    tree.age_years = 40.0;
    EXPECT_LT(colonisation_success(tree, moist, pure), 0.1 * usual);
}

TEST(BeetleHosts, AreCountedOnAPatchAndAroundIt) {
    const PatchGrid grid = square_of_forest(3);
    std::vector<Tree> trees{new_tree(table[spruce], spruce, 15.0, 15.0, 30.0, 25.0, 90.0),
                            new_tree(table[fir], fir, 25.0, 25.0, 30.0, 25.0, 90.0),
                            new_tree(table[spruce], spruce, 15.0, 15.0, 14.0, 15.0, 40.0)};
    for (std::size_t i = 0; i < trees.size(); ++i) {
        trees[i].id = TreeId{i};
    }
    const Stand stand{grid, table.size(), trees, 2000};
    const std::vector<BeetleHosts> hosts = beetle_hosts_of(stand, table);
    const double thin = basal_area_m2(14.0);
    const double thick = basal_area_m2(30.0);
    EXPECT_DOUBLE_EQ(hosts[4].basal_area_m2, thick) << "thin ones are no hosts";
    EXPECT_DOUBLE_EQ(hosts[4].share, thick / (2.0 * thick + thin));
    EXPECT_EQ(hosts[0].basal_area_m2, 0.0);
    // The fir stands in the corner in the north-east: only patches that border on it see it.
    EXPECT_DOUBLE_EQ(hosts[6].share, thick / (thick + thin));
}

}  // namespace
}  // namespace forest::beetle_hosts_test
