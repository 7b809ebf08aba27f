#include "forest/deadwood/decay.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/forest/small_forest.hpp"

namespace forest::decay_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const Deadwood& spruce = table[*table.find("piab")].deadwood;

TEST(DecaySpeed, IsOneAtTenDegreesWithRainEnough) {
    EXPECT_NEAR(decay_speed(10.0, 10.0), 1.0, 1e-9);
    EXPECT_NEAR(decay_speed(4.0, 10.0), 0.5, 0.1) << "subalpine";
    EXPECT_GT(decay_speed(15.0, 10.0), 1.3);
    EXPECT_LT(decay_speed(10.0, 0.2), 0.2) << "too dry to rot";
}

TEST(DecaySpeed, OfAMontaneYearIsThatOfItsMean) {
    EXPECT_NEAR(decay_speed(montane_year()), decay_speed(5.5, 10.0), 0.03);
}

TEST(YearlyDensityLeft, HalvesSpruceLogsInAQuarterOfACenturyUpInTheMountains) {
    double density = 1.0;
    for (int year = 0; year < 24; ++year) {
        density *= yearly_density_left(lying_decay_pyear(spruce), 0.525);
    }
    EXPECT_NEAR(density, 0.5, 0.01);
    EXPECT_NEAR(density, std::exp(-1.69 * spruce.log_decay_pyear * 0.525 * 24.0), 1e-9);
}

TEST(FallChance, LeavesHalfOfTheSnagsAfterTheHalfLife) {
    const double p = fall_chance(spruce, 40.0, 1.0);
    EXPECT_NEAR(std::pow(1.0 - p, spruce.snag_half_life_years), 0.5, 1e-9);
    const double thin = fall_chance(spruce, 15.0, 1.0);
    EXPECT_NEAR(std::pow(1.0 - thin, 0.5 * spruce.snag_half_life_years), 0.5, 1e-9);
    EXPECT_LT(fall_chance(spruce, 40.0, 0.5), p);
}

TEST(BreakageChance, ConcernsThickWholeSnagsFromTheThirdYearOn) {
    const Snag snag{.dbh_cm = 40.0, .tree_height_m = 25.0, .height_m = 25.0, .year = 2000};
    EXPECT_EQ(breakage_chance(snag, 2002, 0.7), 0.0);
    EXPECT_DOUBLE_EQ(breakage_chance(snag, 2003, 0.7), 0.1);
    Snag other = snag;
    other.height_m = 4.0;
    EXPECT_EQ(breakage_chance(other, 2010, 0.7), 0.0);
    other = snag;
    other.dbh_cm = 20.0;
    EXPECT_EQ(breakage_chance(other, 2010, 0.7), 0.0);
}

TEST(Clearance, SettlesOnTheGroundWithin25Years) {
    EXPECT_EQ(clearance_m(fresh_clearance_m, 0.0), 0.45);
    EXPECT_NEAR(clearance_m(fresh_clearance_m, 12.0), 0.45 / std::exp(1.0), 1e-9);
    EXPECT_EQ(clearance_m(fresh_clearance_m, 25.0), 0.0);
}

TEST(StrengthShare, FallsFasterThanDensityAndEndsForStumpsAtTwentyYears) {
    const Log fresh{.density_share = 1.0, .year = 2000};
    EXPECT_EQ(strength_share(fresh, 2000), 1.0);
    const Log old{.density_share = 0.64, .year = 1980};
    EXPECT_NEAR(strength_share(old, 2000), 0.512 * 0.75, 1e-9);
    const Snag stump{.cut = true, .year = 1980, .density_share = 0.64};
    EXPECT_EQ(strength_share(stump, 2000), 0.0);
    EXPECT_NEAR(strength_share(stump, 1995), 0.512, 1e-9);
    const Snag snag{.year = 1980, .density_share = 0.64};
    EXPECT_NEAR(strength_share(snag, 2000), 0.512, 1e-9);
}

}  // namespace
}  // namespace forest::decay_test
