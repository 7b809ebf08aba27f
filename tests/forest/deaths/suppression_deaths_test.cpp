#include "forest/deaths/suppression_deaths.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "forest/deaths/canopy_deaths.hpp"

namespace forest::suppression_deaths_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const Species& beech = table[*table.find("fasy")];
const Species& larch = table[*table.find("lade")];

TEST(SuppressionDeath, FallsWithTheThirdPowerOfShadeAndWithDiameter) {
    const SuppressionDeaths law{
        .in_full_shade = 0.04, .by_class = 0.0, .in_full_light = 0.2, .dbh_scale_cm = 20.0};
    EXPECT_NEAR(suppression_death(beech.light, 0.0, 0.0, law), 0.04, 1e-12);
    EXPECT_NEAR(suppression_death(beech.light, 0.0, 0.5, law), 0.04 * (0.2 + 0.8 / 8.0), 1e-12);
    EXPECT_NEAR(suppression_death(beech.light, 20.0, 0.0, law), 0.04 * std::exp(-1.0), 1e-9);
    EXPECT_NEAR(suppression_death(beech.light, 0.0, 1.0, law), 0.2 * 0.04, 1e-12) << "in the open, too";
}

TEST(SuppressionDeath, TakesLightDemandingTreesFirst) {
    EXPECT_GT(suppression_death(larch.light, 15.0, 0.2, {}),
              2.0 * suppression_death(beech.light, 15.0, 0.2, {}));
}

TEST(SuppressionDeath, MakesDeathsBySizeAU) {
    // Suppressed poles, trees of the canopy, giants (Holzwarth et al. 2013).
    const auto all = [](double dbh_cm, double light, double age_years) {
        return canopy_death(beech, dbh_cm, age_years, CanopyPlace{}, {}) +
               suppression_death(beech.light, dbh_cm, light, {});
    };
    EXPECT_GT(all(5.0, 0.08, 40.0), 2.0 * all(45.0, 0.6, 180.0));
    EXPECT_GT(all(90.0, 1.0, 320.0), 4.0 * all(45.0, 0.6, 180.0));
}

}  // namespace
}  // namespace forest::suppression_deaths_test
