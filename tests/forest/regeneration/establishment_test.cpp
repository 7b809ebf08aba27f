#include "forest/regeneration/establishment.hpp"

#include <gtest/gtest.h>

#include "forest/stand/species_drought.hpp"
#include "tests/forest/small_forest.hpp"

namespace forest::establishment_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();

const Species& kind(const char* code) {
    return table[*table.find(code)];
}

/// The montane year moved by some degrees, deficit and rain as they were.
ClimateYear moved(double by_k) {
    ClimateYear year = montane_year();
    for (std::size_t m = 0; m < 12; ++m) {
        year.months[m].tave_degc += by_k;
        year.months[m].tmin_degc += by_k;
        year.months[m].tmax_degc += by_k;
        year.months[m].frost_days = expected_frost_days(year.months[m].tmin_degc, static_cast<int>(m) + 1);
    }
    return year;
}

TEST(DegreeDayResponse, IsNothingAtTheLimitAndRises) {
    const Response& spruce = kind("piab").response;
    EXPECT_EQ(degree_day_response(spruce, 385.0), 0.0);
    EXPECT_NEAR(degree_day_response(spruce, 385.0 + 1.0 / 0.0013), 1.0 - std::exp(-1.0), 1e-9);
    EXPECT_GT(degree_day_response(spruce, 1300.0), degree_day_response(spruce, 700.0));
}

TEST(ClimateChance, ClosesTheDoorOfEachSpeciesAtItsOwnLimit) {
    // Beech wants no coldest month below -4 degC, fir none below -6, spruce and cembra go on.
    EXPECT_GT(climate_chance(kind("fasy"), moved(0.0)), 0.0);
    EXPECT_EQ(climate_chance(kind("fasy"), moved(-1.0)), 0.0);
    EXPECT_GT(climate_chance(kind("abal"), moved(-1.0)), 0.0);
    EXPECT_EQ(climate_chance(kind("abal"), moved(-3.0)), 0.0);
    EXPECT_GT(climate_chance(kind("piab"), moved(-3.0)), 0.0);
    EXPECT_GT(climate_chance(kind("pice"), moved(-4.0)), 0.0);
    EXPECT_EQ(climate_chance(kind("piab"), moved(-9.0)), 0.0) << "too few degree-days";
}

TEST(ClimateChance, FallsWithLateFrost) {
    ClimateYear frosty = moved(0.0);
    frosty.months[5].frost_days += 4.0;  // June, after any bud burst
    const Species& fir = kind("abal");
    EXPECT_LT(climate_chance(fir, frosty), 0.4 * climate_chance(fir, moved(0.0)));
    EXPECT_LT(climate_chance(fir, frosty) / climate_chance(fir, moved(0.0)),
              climate_chance(kind("piab"), frosty) / climate_chance(kind("piab"), moved(0.0)));
}

TEST(LightChance, FirNeedsLessLightThanSpruceAndSpruceLessThanLarch) {
    EXPECT_GT(light_chance(kind("abal").light, 0.08), 0.0);
    EXPECT_EQ(light_chance(kind("piab").light, 0.08), 0.0);
    EXPECT_GT(light_chance(kind("piab").light, 0.25), 0.5);
    EXPECT_EQ(light_chance(kind("lade").light, 0.25), 0.0);
    EXPECT_EQ(light_chance(kind("lade").light, 1.0), 1.0);
}

TEST(WaterChance, EndsAtTheToleratedDrought) {
    EXPECT_EQ(water_chance(0.0), 1.0);
    EXPECT_NEAR(water_chance(0.5 * tolerated_drought), 0.5, 1e-9);
    EXPECT_EQ(water_chance(0.7), 0.0);
}

TEST(SunChance, CountsAboveTheMontaneBeltOnly) {
    EXPECT_EQ(sun_chance(1300.0, 0.0), 1.0);
    EXPECT_EQ(sun_chance(600.0, 0.0), 0.2);
    EXPECT_EQ(sun_chance(600.0, 1.0), 0.5);
    EXPECT_EQ(sun_chance(600.0, 5.0), 1.0);
}

TEST(SeedBed, IsBetterOnRottenWoodAndWorseUnderHerbs) {
    const SeedBed litter = seed_bed(kind("piab"), {});
    EXPECT_DOUBLE_EQ(litter.ground, 0.038);
    EXPECT_EQ(litter.wood, 0.0);
    EXPECT_DOUBLE_EQ(seed_bed(kind("piab"), {.herbs = 1.0}).ground, 0.2 * litter.ground);
    EXPECT_DOUBLE_EQ(seed_bed(kind("piab"), {.fresh_wood = 0.3}).ground, 0.7 * litter.ground);
    // 4 % of wood carries about 30 % of the seedlings (Bujoczek et al. 2015).
    const SeedBed bed = seed_bed(kind("piab"), {.rotten_wood = 0.04});
    EXPECT_NEAR(bed.wood / (bed.ground + bed.wood), 0.3, 0.02);
    EXPECT_LT(seed_bed(kind("acps"), {.rotten_wood = 0.04}).wood, bed.wood);
    EXPECT_EQ(seed_bed(kind("piab"), {.rotten_wood = 0.6, .fresh_wood = 0.6}).ground, 0.0);
}

}  // namespace
}  // namespace forest::establishment_test
