#include "forest/growth.hpp"

#include <gtest/gtest.h>

#include "forest/stand/allometry.hpp"

namespace forest::growth_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const Species& spruce = table[*table.find("piab")];
const Species& larch = table[*table.find("lade")];

double above_ground_kg(const Species& species, double dbh_cm, double height_m) {
    return part_masses(species.allometry, dbh_cm, height_m, 1.0).above_ground_kg();
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
