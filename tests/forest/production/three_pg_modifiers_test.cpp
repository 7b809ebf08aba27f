#include "forest/production/three_pg_modifiers.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace forest::three_pg_modifiers_test {
namespace {

const TemperatureCurve spruce{2.4727, 24.9494, 30.1378};

TEST(TemperatureModifier, IsOneAtTheOptimumAndNothingOutside) {
    EXPECT_NEAR(temperature_modifier(24.9494, spruce), 1.0, 1e-12);
    EXPECT_EQ(temperature_modifier(2.4727, spruce), 0.0);
    EXPECT_EQ(temperature_modifier(30.1378, spruce), 0.0);
    EXPECT_EQ(temperature_modifier(-40.0, spruce), 0.0);
    EXPECT_EQ(temperature_modifier(40.0, spruce), 0.0);
}

TEST(TemperatureModifier, RisesToTheOptimumAndFallsBeyond) {
    double before = 0.0;
    for (double t = 3.0; t < 24.9; t += 0.5) {
        EXPECT_GT(temperature_modifier(t, spruce), before) << t;
        before = temperature_modifier(t, spruce);
    }
    before = 1.0;
    for (double t = 25.0; t < 30.0; t += 0.5) {
        EXPECT_LT(temperature_modifier(t, spruce), before) << t;
        before = temperature_modifier(t, spruce);
    }
}

TEST(TemperatureModifier, IsTheClosedFormWhereBothSidesAreAlike) {
    // With the optimum in the middle the power is 1: a parabola.
    EXPECT_NEAR(temperature_modifier(5.0, {0.0, 10.0, 20.0}), 0.75, 1e-11);
}

TEST(FrostModifier, TakesADayForADay) {
    EXPECT_DOUBLE_EQ(frost_modifier(15.0, 30.0, 1.0), 0.5);
    EXPECT_DOUBLE_EQ(frost_modifier(15.0, 30.0, 0.0), 1.0);
}

TEST(VpdModifier, TakesKilopascalAndASensitivityPerMillibar) {
    EXPECT_NEAR(vpd_modifier(1.0, 0.05), std::exp(-0.5), 1e-12);
    EXPECT_DOUBLE_EQ(vpd_modifier(0.0, 0.05), 1.0);
}

TEST(SoilWaterModifier, IsHalfAtTheDeficitOfTheSoilClass) {
    for (const double soil_class : {1.0, 2.0, 3.0, 4.0}) {
        const SoilWaterCurve curve = soil_water_curve(soil_class);
        EXPECT_NEAR(soil_water_modifier(1.0 - curve.half_deficit, curve), 0.5, 1e-12);
        EXPECT_DOUBLE_EQ(soil_water_modifier(1.0, curve), 1.0);
    }
    EXPECT_DOUBLE_EQ(soil_water_curve(1.0).half_deficit, 0.7);
    EXPECT_DOUBLE_EQ(soil_water_curve(4.0).power, 3.0);
}

TEST(NutritionModifier, RunsFromItsFloorToOne) {
    EXPECT_DOUBLE_EQ(nutrition_modifier(0.0, {0.6, 1.0}), 0.6);
    EXPECT_DOUBLE_EQ(nutrition_modifier(1.0, {0.6, 1.0}), 1.0);
    EXPECT_NEAR(nutrition_modifier(0.5, {0.6, 1.0}), 0.8, 1e-12);
}

TEST(Co2Modifiers, AreOneAt350AndTheParameterAt700) {
    EXPECT_NEAR(co2_assimilation_modifier(350.0, 1.19), 1.0, 1e-12);
    EXPECT_NEAR(co2_assimilation_modifier(700.0, 1.19), 1.19, 1e-12);
    EXPECT_NEAR(co2_conductance_modifier(350.0, 0.75), 1.0, 1e-12);
    EXPECT_NEAR(co2_conductance_modifier(700.0, 0.75), 0.75, 1e-12);
}

TEST(AgeModifier, IsHalfAtItsRelativeAge) {
    const AgeCurve curve{400.0, 4.0, 0.95};
    EXPECT_NEAR(age_modifier(380.0, curve), 0.5, 1e-12);
    EXPECT_DOUBLE_EQ(age_modifier(0.0, curve), 1.0);
    EXPECT_DOUBLE_EQ(age_modifier(1000.0, {400.0, 0.0, 0.95}), 1.0);
}

TEST(PhysiologicalModifier, TakesTheScarcerOrBoth) {
    EXPECT_DOUBLE_EQ(physiological_modifier(0.8, 0.5, 0.9, Physiology::scarcer), 0.45);
    EXPECT_DOUBLE_EQ(physiological_modifier(0.8, 0.5, 0.9, Physiology::product), 0.36);
}

TEST(PhModifier, FallsBelowTheOptimumToItsFloor) {
    EXPECT_DOUBLE_EQ(ph_modifier(6.0, 4.5), 1.0);
    EXPECT_DOUBLE_EQ(ph_modifier(4.5, 4.5), 1.0);
    EXPECT_NEAR(ph_modifier(4.1, 4.5), 0.5, 1e-12);
    EXPECT_DOUBLE_EQ(ph_modifier(3.0, 4.5), 0.3);
}

TEST(Modifiers, LieBetweenNothingAndOneForAllSpecies) {
    const SpeciesTable species = SpeciesTable::shipped();
    for (const Species& one : species.all()) {
        for (double t = -30.0; t <= 45.0; t += 0.7) {
            const double f = temperature_modifier(t, one.three_pg.temperature);
            EXPECT_GE(f, 0.0) << one.code << " at " << t;
            EXPECT_LE(f, 1.0 + 1e-12) << one.code << " at " << t;
        }
    }
}

}  // namespace
}  // namespace forest::three_pg_modifiers_test
