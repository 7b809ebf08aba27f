#include "forest/regeneration/saplings.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace forest::saplings_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
constexpr config::FourUniforms nobody_dies = {0.0, 0.0, 0.0, 0.0};

const Species& kind(const char* code) {
    return table[*table.find(code)];
}

/// Years from a seedling to 1.3 m.
int years_to_breast_height(const Species& species, const SaplingPlace& place) {
    Cohort cohort{.stems = 1, .height_m = seedling_height_m};
    int years = 0;
    while (cohort.height_m < 1.3 && years < 500) {
        cohort.height_m = year_of_cohort(species, cohort, place, nobody_dies).growth.height_m;
        ++years;
    }
    return years;
}

TEST(PotentialHeight, AfterManyYearsIsThatOfTheClosedForm) {
    const Saplings& spruce = kind("piab").saplings;
    double height_m = seedling_height_m;
    for (int year = 0; year < 20; ++year) {
        height_m = potential_height_m(spruce, height_m);
    }
    const double start = std::cbrt(seedling_height_m / spruce.max_height_m);
    const double place = 1.0 - (1.0 - start) * std::exp(-20.0 * spruce.rate_pyear);
    EXPECT_NEAR(height_m, spruce.max_height_m * place * place * place, 1e-6);
}

TEST(YearOfCohort, BringsSpruceInFullLightToBreastHeightSoonBelowAndLateAbove) {
    // Warmth of 1000 m (1300 degree-days) and of 1750 m (605), nitrogen of a middling soil, their geometric
    // mean with enough water.
    const Species& spruce = kind("piab");
    EXPECT_EQ(years_to_breast_height(spruce, {.environment = 1.0}), 10);
    const int low = years_to_breast_height(spruce, {.environment = std::cbrt(0.696 * 0.854)});
    EXPECT_GE(low, 11);
    EXPECT_LE(low, 13);
    const int high = years_to_breast_height(spruce, {.environment = std::cbrt(0.249 * 0.854)});
    EXPECT_GE(high, 15);
    EXPECT_LE(high, 19);
}

TEST(YearOfCohort, FirGrowsInLightThatStopsSpruceAndLarch) {
    const SaplingPlace dark{.environment = 0.7, .ground_light = 0.1};
    const Cohort cohort{.stems = 10, .height_m = 0.5};
    const auto growth_m = [&](const char* code) {
        return year_of_cohort(kind(code), cohort, dark, nobody_dies).growth.height_m - 0.5;
    };
    EXPECT_GT(growth_m("abal"), 1.2 * growth_m("piab"));
    EXPECT_GT(growth_m("piab"), growth_m("lade"));
}

TEST(BrowsingChance, IsTheSpeciesOwnAtNormalPressureAndRisesInOdds) {
    const Saplings& fir = kind("abal").saplings;
    EXPECT_EQ(browsing_chance(fir, 0.5, 0.0), 0.0);
    EXPECT_NEAR(browsing_chance(fir, 0.5, 1.0), fir.browsing_probability, 1e-12);
    const double p = browsing_chance(fir, 0.5, 3.0);
    EXPECT_NEAR(p / (1.0 - p), 3.0 * fir.browsing_probability / (1.0 - fir.browsing_probability), 1e-9);
    EXPECT_EQ(browsing_chance(fir, 0.05, 3.0), 0.0);
    EXPECT_EQ(browsing_chance(fir, 1.5, 3.0), 0.0);
}

TEST(YearOfCohort, DeerTakeFirAndRowanFirst) {
    const auto with_deer = [](const char* code, double pressure) {
        Cohort cohort{.stems = 100'000, .height_m = 0.2};
        const SaplingPlace place{.environment = 0.6, .ground_light = 0.6, .deer = pressure};
        for (int year = 0; year < 15; ++year) {
            const SaplingYear passed = year_of_cohort(kind(code), cohort, place, nobody_dies);
            cohort.height_m = passed.growth.height_m;
            cohort.stems -= passed.browsed + passed.background;
        }
        return cohort;
    };
    for (const char* tasty : {"abal", "soau"}) {
        EXPECT_GT(with_deer(tasty, 0.0).height_m, 1.3) << tasty;
        EXPECT_LT(with_deer(tasty, 3.0).height_m, 0.5) << tasty;
        EXPECT_LT(with_deer(tasty, 3.0).stems, 0.5 * with_deer(tasty, 0.0).stems) << tasty;
    }
    EXPECT_GT(with_deer("piab", 3.0).height_m, 1.0);
    EXPECT_GT(with_deer("piab", 3.0).stems, 0.9 * with_deer("piab", 0.0).stems);
}

TEST(YearOfCohort, KillsAfterTooManyYearsOfStressAndForgetsThemInAGoodOne) {
    const Species& spruce = kind("piab");
    const SaplingPlace dark{.environment = 0.5, .ground_light = 0.05};
    Cohort cohort{.stems = 50, .height_m = 0.3};
    cohort.stress_years = 2;
    EXPECT_EQ(year_of_cohort(spruce, cohort, dark, nobody_dies).stressed, 0U);
    cohort.stress_years = 3;
    EXPECT_EQ(year_of_cohort(spruce, cohort, dark, nobody_dies).stressed, 50U);
    EXPECT_EQ(year_of_cohort(spruce, cohort, {}, nobody_dies).growth.stress_years, 0U);
}

TEST(YearOfCohort, LosesAFifthOfPlantedTreesInTwoYears) {
    const Species& spruce = kind("piab");
    Cohort seeded{.stems = 1'000'000, .height_m = 0.35};
    Cohort planted = seeded;
    planted.origin = Origin::planted;
    for (std::uint16_t year = 0; year < 2; ++year) {
        for (Cohort* cohort : {&seeded, &planted}) {
            cohort->stems -= year_of_cohort(spruce, *cohort, {}, nobody_dies).background;
            cohort->age_years = static_cast<std::uint16_t>(year + 1);
        }
    }
    EXPECT_NEAR(static_cast<double>(planted.stems) / seeded.stems, 0.8, 0.015);
}

TEST(RoomOfStem, IsThatOfTheDensityLine) {
    EXPECT_NEAR(1.0 / room_of_stem(1.0), 100.0, 1e-9);
    EXPECT_NEAR(1.0 / room_of_stem(2.0), 43.5, 0.1);
    EXPECT_EQ(room_of_stem(0.1), room_of_stem(0.5));
}

}  // namespace
}  // namespace forest::saplings_test
