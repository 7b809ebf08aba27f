#include "forest/protection/stand_indicators.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "forest/start/starting_stand.hpp"
#include "tests/forest/small_forest.hpp"

namespace forest::stand_indicators_test {
namespace {

const SpeciesTable& shipped_species() {
    static const SpeciesTable table = SpeciesTable::shipped();
    return table;
}

Tree spruce(double x_m, double y_m, double dbh_cm, double height_m) {
    const SpeciesId piab = *shipped_species().find("piab");
    Tree tree = new_tree(shipped_species()[piab], piab, x_m, y_m, dbh_cm, height_m, 60.0);
    tree.crown.radius_m = 2.0;
    tree.crown.base_m = 0.4 * height_m;
    return tree;
}

StandIndicators of(const Stand& stand) {
    return indicators_of(stand, shipped_species(), [](const Patch&) { return true; });
}

TEST(StandIndicators, CoverOfRandomCrownsFollowsThePoissonLaw) {
    EXPECT_EQ(cover_of(0.0), 0.0);
    EXPECT_NEAR(cover_of(std::log(2.0)), 0.5, 1e-15);
    EXPECT_LT(cover_of(5.0), 1.0);
}

TEST(StandIndicators, MeasureATreeOnOneOfFourPatches) {
    std::vector<Tree> trees{spruce(5.0, 5.0, 30.0, 28.0), spruce(6.0, 5.0, 8.0, 6.0)};
    trees[0].id = TreeId{1};
    trees[1].id = TreeId{2};
    const StandIndicators found = of({square_of_forest(2), shipped_species().size(), trees, 2000});
    const double crown_share = std::numbers::pi * 4.0 / 100.0;
    EXPECT_NEAR(found.cover_percent, 100.0 * cover_of(crown_share) / 4.0, 1e-9);
    EXPECT_NEAR(found.regeneration_percent, 100.0 * cover_of(crown_share) / 4.0, 1e-9);
    EXPECT_NEAR(found.regeneration_pha, 25.0, 1e-9);
    EXPECT_NEAR(found.slenderness, 2800.0 / 30.0, 1e-9);
    EXPECT_EQ(found.slender_percent, 100.0) << "93 is above 90";
    EXPECT_NEAR(found.crown_ratio_percent, 60.0, 1e-9);
    EXPECT_EQ(found.logs_m3pha, 0.0);
}

TEST(StandIndicators, AreUnknownWhereNothingStands) {
    const StandIndicators bare = of({square_of_forest(2), shipped_species().size(), {}, 2000});
    EXPECT_EQ(bare.cover_percent, 0.0);
    EXPECT_TRUE(std::isnan(bare.slenderness));
    EXPECT_TRUE(std::isnan(bare.slender_percent));
}

}  // namespace
}  // namespace forest::stand_indicators_test
