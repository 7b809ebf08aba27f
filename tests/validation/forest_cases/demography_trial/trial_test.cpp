#include "validation/engine/forest_cases/demography_trial/trial.hpp"

#include <gtest/gtest.h>

#include "tests/validation/forest_cases/shipped_case.hpp"
#include "validation/engine/forest_cases/shared/level_forest.hpp"

namespace coupling::validation::forest_cases::demography_trial::trial_test {
namespace {

std::vector<forest::ClimateYear> shipped_climate() {
    config::Warnings warnings;
    return forest::read_climate_of_one_place(shipped_table("forest_demography", "climate.csv"), warnings)
        .years;
}

TEST(ShiftedTo, GivesTheDegreeDaysAndTheWetnessAskedFor) {
    const std::vector<forest::ClimateYear> years = shipped_climate();
    for (const PlaceClimate& wanted : {PlaceClimate{2629.0, -0.01}, PlaceClimate{575.0, 1.15}}) {
        const PlaceClimate found = climate_of(shifted_to(years, wanted));
        EXPECT_NEAR(found.degree_days, wanted.degree_days, 0.001 * wanted.degree_days);
        EXPECT_NEAR(found.wetness, wanted.wetness, 1e-6);
    }
}

TEST(Fate, GivesTheMeanOfSurvivorsAndAYearlyRate) {
    Fate fate{.trees = 10, .survivors = 8, .growth_mm_pyear = 24.0};
    fate += Fate{.trees = 10, .survivors = 10, .growth_mm_pyear = 30.0};
    EXPECT_NEAR(fate.mean_growth_mm_pyear(), 3.0, 1e-12);
    EXPECT_NEAR(fate.mortality_pyear(10), 0.010481, 1e-6) << "0.9 left after ten years";
}

TEST(GrowDemography, FollowsFourTreesOfOneSize) {
    const forest::SpeciesTable species = forest::SpeciesTable::shipped();
    const std::vector<forest::ClimateYear> climate = shipped_climate();
    const forest::Site site = level_site(trial_grid(), config::Angle::from_degrees(47.7), climate);
    DemographyTrial trial{.species = *species.find("abal"),
                          .dbh_cm = 30.0,
                          .larger_m2pha = 20.0,
                          .climate = climate,
                          .degree_days = 1900.0,
                          .parameters = shipped_parameters("forest_demography", CaseKind::forest_demography),
                          .years = 3};
    const Fate fate = grow_demography(trial, site, species, {1, 0});
    EXPECT_EQ(fate.trees, 4U);
    EXPECT_LE(fate.survivors, 4U);
    EXPECT_GT(fate.mean_growth_mm_pyear(), 1.0);
    EXPECT_LT(fate.mean_growth_mm_pyear(), 15.0);
}

}  // namespace
}  // namespace coupling::validation::forest_cases::demography_trial::trial_test
