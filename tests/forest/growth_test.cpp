#include "forest/growth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "forest/allometry.hpp"
#include "forest/crown.hpp"

namespace forest::growth_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const Species& spruce = table[*table.find("piab")];
const Species& larch = table[*table.find("lade")];

double above_ground_kg(const Species& species, double dbh_cm, double height_m) {
    return part_masses(species.allometry, dbh_cm, height_m, 1.0).above_ground_kg();
}

TEST(Allometry, GivesThePublishedLeavesOfAThickSpruce) {
    // 0.0956 * 30^1.56 = 19 kg and 82 m2.
    EXPECT_NEAR(part_masses(spruce.allometry, 30.0, 28.0, 1.0).foliage_kg, 19.3, 0.1);
    EXPECT_NEAR(leaf_area_m2(spruce, 30.0, 1.0), 82.0, 0.5);
}

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

TEST(LightResponse, LiesBetweenTheTwoCurvesAndRisesWithLight) {
    EXPECT_DOUBLE_EQ(light_response(1.0, 0.05), 0.0);
    EXPECT_NEAR(light_response(1.0, 1.0), 1.0 - std::exp(-4.64 * 0.95), 1e-9);
    EXPECT_NEAR(light_response(9.0, 0.5), 2.24 * (1.0 - std::exp(-1.136 * 0.42)), 1e-9);
    for (double light = 0.0; light < 1.0; light += 0.01) {
        EXPECT_LE(light_response(4.6, light), light_response(4.6, light + 0.01));
    }
}

TEST(LightResponse, LetsTolerantSpeciesGrowWhereOthersDoNot) {
    EXPECT_GT(light_response(1.0, 0.1), 3.0 * light_response(9.0, 0.1));
}

TEST(HeightDiameterRatio, IsLargerInShade) {
    EXPECT_GT(height_diameter_ratio(spruce.height_growth, 20.0, 0.2, 1.0),
              height_diameter_ratio(spruce.height_growth, 20.0, 0.8, 1.0));
}

TEST(IncrementOf, TurnsAllOfTheGainIntoWood) {
    for (const double dbh_cm : {1.0, 5.0, 20.0, 60.0}) {
        for (const double gain_kg : {1e-6, 0.01, 1.0, 5.0}) {
            const double height_m = 1.3 + 0.6 * dbh_cm;
            const Increment increment = increment_of(spruce, {dbh_cm, height_m, 1.0}, 80.0, gain_kg);
            if (increment.dbh_cm == largest_increment_cm) {
                continue;
            }
            const double gained_kg =
                above_ground_kg(spruce, dbh_cm + increment.dbh_cm, height_m + increment.height_m) -
                above_ground_kg(spruce, dbh_cm, height_m);
            EXPECT_NEAR(gained_kg, gain_kg, 1e-9 * (gain_kg + above_ground_kg(spruce, dbh_cm, height_m)));
            EXPECT_DOUBLE_EQ(increment.height_m, 0.8 * increment.dbh_cm);
        }
    }
}

TEST(IncrementOf, StopsAtTheGreatestHeightAndGoesOnInThickness) {
    const double top_m = spruce.height_growth.max_height_m;
    const Increment increment = increment_of(spruce, {80.0, top_m - 0.1, 1.0}, 80.0, 60.0);
    EXPECT_DOUBLE_EQ(increment.height_m, top_m - (top_m - 0.1));
    EXPECT_NEAR(
        above_ground_kg(spruce, 80.0 + increment.dbh_cm, top_m) - above_ground_kg(spruce, 80.0, top_m - 0.1),
        60.0, 1e-6);
}

TEST(IncrementOf, LeavesWhatATreeOfGreatestThicknessCannotPlace) {
    const double most_cm = larch.height_growth.max_dbh_cm;
    const Increment increment = increment_of(larch, {most_cm, 40.0, 1.0}, 50.0, 30.0);
    EXPECT_EQ(increment.dbh_cm, 0.0);
    EXPECT_EQ(increment.used_kg, 0.0);
}

TEST(IncrementOf, IsNothingWithoutGain) {
    EXPECT_EQ(increment_of(spruce, {20.0, 15.0, 1.0}, 80.0, 0.0).dbh_cm, 0.0);
    EXPECT_EQ(increment_of(spruce, {20.0, 15.0, 1.0}, 80.0, -1.0).dbh_cm, 0.0);
}

}  // namespace
}  // namespace forest::growth_test
