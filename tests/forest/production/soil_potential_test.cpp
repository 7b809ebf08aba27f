#include "forest/production/soil_potential.hpp"

#include <gtest/gtest.h>

#include "forest/stand/species.hpp"

namespace forest::soil_potential_test {
namespace {

TEST(SoilPotential, RunsFromFieldCapacityToWilting) {
    for (const int soil_class : {1, 2, 3, 4}) {
        const SoilPotential soil = soil_potential_of(soil_class);
        EXPECT_NEAR(potential_mpa(soil, 1.0), field_capacity_mpa, 1e-12) << soil_class;
        EXPECT_NEAR(potential_mpa(soil, 0.0), wilting_mpa, 1e-9) << soil_class;
        double before_mpa = potential_mpa(soil, 0.0);
        for (int percent = 5; percent <= 100; percent += 5) {
            const double now_mpa = potential_mpa(soil, 0.01 * percent);
            EXPECT_GT(now_mpa, before_mpa) << soil_class << ", " << percent << " %";
            before_mpa = now_mpa;
        }
    }
}

TEST(SoilPotential, OfClayFallsAsThePowerOfItsWater) {
    // Half way between wilting w and field capacity 1 the water is (1 + w) / 2 of that at field capacity.
    const SoilPotential clay = soil_potential_of(4);
    const double water = 0.5 * (1.0 + clay.wilting_share);
    EXPECT_NEAR(potential_mpa(clay, 0.5), -0.015 * std::pow(water, -11.4), 1e-9);
}

TEST(WaterResponse, IsALineFromTheThresholdToFieldCapacity) {
    EXPECT_EQ(water_response(field_capacity_mpa, -0.5), 1.0);
    EXPECT_EQ(water_response(-0.5, -0.5), 0.0);
    EXPECT_EQ(water_response(-3.0, -0.5), 0.0);
    EXPECT_NEAR(water_response(0.5 * (field_capacity_mpa - 0.5), -0.5), 0.5, 1e-12);
}

TEST(WaterResponse, RanksTheSpeciesAsTheirThresholdsDo) {
    const SpeciesTable species = SpeciesTable::shipped();
    const auto of = [&](const char* code) {
        return water_response(-0.6, species[species.find(code).value()].response.min_potential_mpa);
    };
    EXPECT_GT(of("pisy"), of("qupe"));
    EXPECT_GT(of("qupe"), of("pice"));
    EXPECT_GT(of("pice"), of("lade"));
    EXPECT_GT(of("lade"), of("fasy"));
    EXPECT_GT(of("fasy"), 0.3);
    EXPECT_EQ(of("abal"), 0.0);
    EXPECT_EQ(of("piab"), 0.0);
}

}  // namespace
}  // namespace forest::soil_potential_test
