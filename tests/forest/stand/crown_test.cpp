#include "forest/stand/crown.hpp"

#include <gtest/gtest.h>

namespace forest::crown_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const Species& spruce = table[*table.find("piab")];

TEST(Crown, HasTheSizeThatItsSourceGives) {
    EXPECT_NEAR(crown_diameter_m(spruce.crown, 30.0, 28.0), 3.99, 0.01);
    EXPECT_NEAR(usual_crown_base_m(spruce.crown, 30.0, 28.0), 14.1, 0.1);
    EXPECT_NEAR(crown_diameter_m(table[*table.find("fasy")].crown, 30.0, 26.0), 7.4, 0.05);
}

TEST(UsualCrownBase, OfATreeMoreSlenderThanAnyMeasuredIsThatOfSlenderness100) {
    // The law was used at 160 to 180 m/m and left fir a quarter of its crown, above that of beech.
    for (const char* code : {"piab", "abal", "fasy", "lade"}) {
        const Crown& crown = table[*table.find(code)].crown;
        const double ratio_at_100 = 1.0 - usual_crown_base_m(crown, 12.0, 12.0) / 12.0;
        const double ratio_at_170 = 1.0 - usual_crown_base_m(crown, 12.0, 20.4) / 20.4;
        EXPECT_NEAR(ratio_at_170, ratio_at_100, 1e-12) << code;
        EXPECT_GT(1.0 - usual_crown_base_m(crown, 12.0, 8.0) / 8.0, ratio_at_100 - 1e-12) << code;
    }
}

TEST(UsualCrownBase, HasTheMeanOfTheMappedStandOfPrenovel) {
    // Crown length / height of its trees (validation/forest_light/trees.csv) at mean diameters and heights.
    const auto ratio = [](const char* code, double dbh_cm, double height_m) {
        return 1.0 - usual_crown_base_m(table[*table.find(code)].crown, dbh_cm, height_m) / height_m;
    };
    EXPECT_NEAR(ratio("abal", 33.0, 21.0), 0.67, 0.03);
    EXPECT_NEAR(ratio("piab", 37.0, 24.5), 0.61, 0.04);
    EXPECT_NEAR(ratio("fasy", 31.0, 20.0), 0.55, 0.03);
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
    EXPECT_DOUBLE_EQ(shaded.completeness, 0.7) << "the least";
    EXPECT_NEAR(shaded.leaf_area_m2 / full_m2, 0.7, 1e-9);
}

}  // namespace
}  // namespace forest::crown_test
