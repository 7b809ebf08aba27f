#include "forest/crown.hpp"

#include <gtest/gtest.h>

namespace forest::crown_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const Species& spruce = table[*table.find("piab")];

TEST(Crown, HasTheSizeThatItsSourceGives) {
    EXPECT_NEAR(crown_diameter_m(spruce.crown, 30.0, 28.0), 3.99, 0.01);
    EXPECT_NEAR(usual_crown_base_m(spruce.crown, 30.0, 28.0), 16.4, 0.1);
    EXPECT_NEAR(crown_diameter_m(table[*table.find("fasy")].crown, 30.0, 26.0), 7.4, 0.05);
}

TEST(NextCrown, NeverSinksAndKeepsAnEighthOfTheTree) {
    for (const double light : {0.0, 0.5, 1.0}) {
        for (const double shaded_m : {0.0, 10.0, 50.0}) {
            TreeCrown crown = starting_crown(spruce, 20.0, 18.0);
            double before_m = crown.base_m;
            for (int year = 0; year < 60; ++year) {
                crown = next_crown(spruce, crown, {20.0, 18.0, 0.0, light, shaded_m});
                EXPECT_GE(crown.base_m, before_m);
                EXPECT_LE(crown.base_m, 0.88 * 18.0);
                EXPECT_LE(crown.base_m - before_m, 0.3 + 1e-12);
                before_m = crown.base_m;
            }
        }
    }
}

TEST(NextCrown, HasFoliageInProportionToItsLengthWithinLimits) {
    const TreeCrown usual = starting_crown(spruce, 20.0, 18.0);
    const double full_m2 = usual.leaf_area_m2;
    TreeCrown shaded = usual;
    for (int year = 0; year < 60; ++year) {
        shaded = next_crown(spruce, shaded, {20.0, 18.0, 0.0, 0.1, 17.0});
    }
    EXPECT_DOUBLE_EQ(shaded.completeness, 0.4) << "the least";
    EXPECT_NEAR(shaded.leaf_area_m2 / full_m2, 0.4, 1e-9);
}

}  // namespace
}  // namespace forest::crown_test
