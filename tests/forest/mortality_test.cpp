#include "forest/mortality.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/forest/small_forest.hpp"

namespace forest::mortality_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const SpeciesId spruce = *table.find("piab");

TEST(BackgroundDeath, OfTheGapModelLeavesFewAtTheGreatestAge) {
    const Mortality& law = table[spruce].mortality;
    const double p = background_death(law, 50.0, AgeLaw::gap_model);
    EXPECT_NEAR(std::pow(1.0 - p, law.max_age_years), law.lucky_share, 1e-9);
    EXPECT_NEAR(p, 0.0077, 0.0001);
}

TEST(BackgroundDeath, RisesWithAgeAndLeavesNobodyMuchBeyondTheGreatest) {
    const Mortality& law = table[spruce].mortality;
    double alive = 1.0;
    double before = 0.0;
    for (int age = 0; age < 600; ++age) {
        const double p = background_death(law, age, AgeLaw::small_and_rising);
        EXPECT_GE(p, before);
        before = p;
        alive *= 1.0 - p;
        if (age == 100) {
            EXPECT_GT(alive, 0.8);
        }
    }
    EXPECT_LT(alive, 0.05);
}

TEST(StressDeath, IsHigherForLightDemandingSpecies) {
    const MortalityLaw law;
    EXPECT_DOUBLE_EQ(stress_death(table[*table.find("abal")].light, law), 0.02);
    EXPECT_NEAR(stress_death(table[spruce].light, law), 0.074, 1e-9);
    EXPECT_GT(stress_death(table[*table.find("lade")].light, law), 0.12);
}

/// Spruces with a growth of the last year, on one patch.
Stand spruces(const std::vector<double>& increments_cm, std::uint16_t stress_years) {
    const PatchGrid grid = square_of_forest(1);
    std::vector<Tree> trees;
    for (std::size_t i = 0; i < increments_cm.size(); ++i) {
        Tree tree = new_tree(table[spruce], spruce, 5.0, 5.0, 20.0, 15.0, 60.0);
        tree.id = TreeId{i};
        tree.increments_cm[0] = increments_cm[i];
        tree.stress_years = stress_years;
        trees.push_back(tree);
    }
    return {grid, table.size(), trees, 2000};
}

TEST(StressYears, CountBadYearsAndForgetThemInAGoodOne) {
    const Stand stand = spruces({0.5, 0.02, 0.04, 0.5}, 2);
    const std::vector<std::uint16_t> years =
        stress_years_after(stand, {}, std::vector<std::uint32_t>(4, 0), 1);
    // Mean 0.265 cm: below 0.03 cm is bad, 0.04 cm is above a tenth of the mean.
    EXPECT_EQ(years, (std::vector<std::uint16_t>{0, 3, 0, 0}));
}

TEST(StressYears, ComeWithATenthOfTheGrowthOfOthers) {
    const Stand stand = spruces({1.0, 1.0, 0.05}, 0);
    EXPECT_EQ(stress_years_after(stand, {}, std::vector<std::uint32_t>(3, 0), 1)[2], 1U);
    // In a unit of its own it is the measure of itself.
    EXPECT_EQ(stress_years_after(stand, {}, std::vector<std::uint32_t>{0, 0, 1}, 2)[2], 0U);
}

TEST(NaturalDeaths, ComeAsOftenAsTheirChanceSays) {
    const Stand stand = spruces(std::vector<double>(20'000, 0.0), 3);
    MortalityLaw law;
    law.background = false;
    const auto deaths = static_cast<double>(natural_deaths(stand, table, law, 1, 0).size());
    const double p = stress_death(table[spruce].light, law);
    EXPECT_NEAR(deaths / 20'000.0, p, 4.0 * std::sqrt(p * (1.0 - p) / 20'000.0));
}

TEST(NaturalDeaths, NeedThreeBadYears) {
    MortalityLaw law;
    law.background = false;
    EXPECT_TRUE(natural_deaths(spruces(std::vector<double>(1000, 0.0), 2), table, law, 1, 0).empty());
}

}  // namespace
}  // namespace forest::mortality_test
