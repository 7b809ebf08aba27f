#include "forest/saplings/saplings.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace forest::saplings_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
constexpr config::FourUniforms nobody_dies = {0.0, 0.0, 0.0, 0.999};

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
    // Warmth of 1000 m (1300 degree-days) and of 1750 m (605) times the cube root of the nitrogen of a
    // middling soil with enough water, as young trees have it in a year of the forest.
    const Species& spruce = kind("piab");
    EXPECT_EQ(years_to_breast_height(spruce, {.environment = 1.0}), 6);
    const int low = years_to_breast_height(spruce, {.environment = 0.696 * std::cbrt(0.854)});
    EXPECT_GE(low, 8);
    EXPECT_LE(low, 11);
    const int high = years_to_breast_height(spruce, {.environment = 0.249 * std::cbrt(0.854)});
    EXPECT_GE(high, 21);
    EXPECT_LE(high, 26);
}

TEST(YearOfCohort, FirGrowsInLightThatStopsSpruceAndLarch) {
    const SaplingPlace dark{.environment = 0.7, .ground_light = 0.1};
    const Cohort cohort{.stems = 10, .height_m = 0.5};
    const auto growth_m = [&](const char* code) {
        return year_of_cohort(kind(code), cohort, dark, nobody_dies).growth.height_m - 0.5;
    };
    EXPECT_GT(growth_m("abal"), growth_m("piab"));
    EXPECT_GT(growth_m("piab"), growth_m("lade"));
}

TEST(BrowsingChance, IsThatOfTheSpeciesAtNormalPressureAndRisesInOdds) {
    const Saplings& fir = kind("abal").saplings;
    EXPECT_EQ(browsing_chance(fir, 0.0), 0.0);
    const double own_odds = fir.browsing_probability / (1.0 - fir.browsing_probability);
    for (const double pressure : {0.3, 1.0, 3.0}) {
        const double p = browsing_chance(fir, pressure);
        EXPECT_NEAR(p / (1.0 - p), std::pow(pressure, 1.81) * own_odds, 1e-9);
    }
    EXPECT_EQ(browsing_chance(fir, 1.0), fir.browsing_probability);
    EXPECT_NEAR(browsing_chance(fir, 3.0), 0.71, 0.005) << "iLand's, where deer are many";
    EXPECT_LT(browsing_chance(kind("piab").saplings, 1.0), 0.025);
}

TEST(BrowsingChance, IsWhatTheSwissInventoryFoundAtNormalPressure) {
    // Leading shoots browsed within a year, 2009-2013: fir in the two montane belts, the others in the whole
    // country, each with its standard error.
    struct Found {
        const char* code;
        double share;
        double error;
    };
    for (const auto& [code, share, error] :
         {Found{"abal", 0.249, 0.061}, Found{"acps", 0.193, 0.021}, Found{"qupe", 0.357, 0.034}}) {
        EXPECT_NEAR(browsing_chance(kind(code).saplings, 1.0), share, error) << code;
    }
    EXPECT_LT(browsing_chance(kind("piab").saplings, 1.0), browsing_chance(kind("abal").saplings, 1.0));
    EXPECT_LT(browsing_chance(kind("fasy").saplings, 1.0), browsing_chance(kind("abal").saplings, 1.0));
}

TEST(PressureOfBrowsing, IsTheInverseOfItsChance) {
    for (const char* code : {"abal", "piab", "soau"}) {
        const Saplings& species = kind(code).saplings;
        for (const double pressure : {0.0, 0.3, 1.0, 3.0, 10.0}) {
            EXPECT_NEAR(*pressure_of_browsing(species, browsing_chance(species, pressure)), pressure, 1e-9);
        }
        EXPECT_FALSE(pressure_of_browsing(species, 1.0)) << "no pressure browses all stems in every year";
    }
    Saplings left_alone;
    EXPECT_FALSE(pressure_of_browsing(left_alone, 0.1));
}

TEST(ShareInReach, FallsAsTheTallestEscape) {
    EXPECT_EQ(share_in_reach(0.05), 0.0) << "below the snow and the herbs";
    EXPECT_EQ(share_in_reach(0.5), 1.0);
    EXPECT_EQ(share_in_reach(0.9), 1.0);
    EXPECT_NEAR(share_in_reach(1.3), 0.5, 1e-12);
    EXPECT_EQ(share_in_reach(2.2), 0.0);
}

/// Stems of 2 m or more after some years, of a thousand cohorts of 10; deer find each or not.
double grown_up(const char* code, double pressure, int years) {
    double stems = 0.0;
    for (std::uint64_t id = 0; id < 1000; ++id) {
        Cohort cohort{.stems = 10, .height_m = 0.3, .age_years = 8};
        const SaplingPlace place{.environment = 0.8, .ground_light = 0.5, .deer = pressure};
        for (int year = 0; year < years && cohort.height_m < recruitment_height_m; ++year) {
            const config::RandomStream stream{{7, 0, static_cast<std::uint16_t>(year), id},
                                              config::Purpose::test};
            const SaplingYear passed = year_of_cohort(kind(code), cohort, place, stream.uniforms_of(0));
            cohort.height_m = passed.growth.height_m;
            cohort.stems -= passed.browsed + passed.background + passed.stressed;
        }
        stems += cohort.height_m >= recruitment_height_m ? cohort.stems : 0.0;
    }
    return stems / 10'000.0;
}

TEST(YearOfCohort, UsualBrowsingThinsFirAndDoesNotExterminateIt) {
    // The chance was applied to the mean height of each cohort, so that no fir ever grew out of reach.
    const double unbrowsed = grown_up("abal", 0.0, 40);
    EXPECT_GT(unbrowsed, 0.5);
    EXPECT_GT(grown_up("abal", 1.0, 40), 0.2 * unbrowsed);
    EXPECT_LT(grown_up("abal", 1.0, 40), 0.9 * unbrowsed);
}

TEST(YearOfCohort, HeavyBrowsingTakesFirAndRowanAndLeavesSpruce) {
    EXPECT_LT(grown_up("abal", 3.0, 30), 0.1 * grown_up("abal", 0.0, 30));
    EXPECT_LT(grown_up("soau", 3.0, 30), 0.3 * grown_up("soau", 0.0, 30)) << "it grows out of reach sooner";
    EXPECT_GT(grown_up("piab", 3.0, 40), 0.9 * grown_up("piab", 0.0, 40));
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

TEST(YearOfCohort, LosesAQuarterOfSeedlingsAYearUntilTheyAreSevenAndFewAfter) {
    const Species& fir = kind("abal");
    Cohort cohort{.stems = 1'000'000, .height_m = 0.1};
    const SaplingPlace shade{.environment = 0.5, .ground_light = 0.15};
    for (std::uint16_t age = 0; age < 7; ++age) {
        cohort.age_years = age;
        cohort.stems -= year_of_cohort(fir, cohort, shade, nobody_dies).background;
    }
    EXPECT_NEAR(cohort.stems / 1e6, std::pow(0.75, 7.0), 1e-4);
    cohort.age_years = 7;
    EXPECT_EQ(year_of_cohort(fir, cohort, shade, nobody_dies).background,
              static_cast<std::uint32_t>(0.03 * cohort.stems));
    Cohort sprout{.origin = Origin::sprout, .stems = 100, .height_m = 0.4};
    EXPECT_EQ(year_of_cohort(fir, sprout, shade, nobody_dies).background, 3U);
}

TEST(YearOfCohort, TellsWhetherDeerFoundIt) {
    const Cohort cohort{.stems = 10, .height_m = 0.5};
    const SaplingPlace place{.deer = 1.0};
    EXPECT_TRUE(year_of_cohort(kind("abal"), cohort, place, {0.9, 0.9, 0.9, 0.0}).growth.browsed);
    EXPECT_FALSE(year_of_cohort(kind("abal"), cohort, place, {0.9, 0.9, 0.9, 0.9}).growth.browsed);
    EXPECT_TRUE(is_in_reach(0.5));
    EXPECT_FALSE(is_in_reach(1.4) || is_in_reach(0.05));
}

TEST(YearOfCohort, LosesAFifthOfPlantedTreesInTwoYears) {
    const Species& spruce = kind("piab");
    Cohort sprouted{.origin = Origin::sprout, .stems = 1'000'000, .height_m = 0.35};
    Cohort planted = sprouted;
    planted.origin = Origin::planted;
    for (std::uint16_t year = 0; year < 2; ++year) {
        for (Cohort* cohort : {&sprouted, &planted}) {
            cohort->stems -= year_of_cohort(spruce, *cohort, {}, nobody_dies).background;
            cohort->age_years = static_cast<std::uint16_t>(year + 1);
        }
    }
    EXPECT_NEAR(static_cast<double>(planted.stems) / sprouted.stems, 0.8, 0.015);
}

TEST(RoomOfStem, IsThatOfTheDensityLine) {
    EXPECT_NEAR(1.0 / room_of_stem(1.0), 100.0, 1e-9);
    EXPECT_NEAR(1.0 / room_of_stem(2.0), 43.5, 0.1);
    EXPECT_EQ(room_of_stem(0.1), room_of_stem(0.5));
}

}  // namespace
}  // namespace forest::saplings_test
