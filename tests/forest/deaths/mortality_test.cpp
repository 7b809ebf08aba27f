#include "forest/deaths/mortality.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/forest/small_forest.hpp"

namespace forest::mortality_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const SpeciesId spruce = *table.find("piab");

constexpr bool storms = true;

TEST(BackgroundDeath, OfTheGapModelLeavesFewAtTheGreatestAge) {
    const Species& kind = table[spruce];
    const MortalityLaw law{.age = AgeLaw::gap_model, .canopy = {}};
    const double p = background_death(kind, 30.0, 50.0, CanopyPlace{}, law, !storms);
    EXPECT_NEAR(std::pow(1.0 - p, kind.mortality.max_age_years), kind.mortality.lucky_share, 1e-9);
    EXPECT_NEAR(p, 0.0077, 0.0001);
}

TEST(BackgroundDeath, RisesWithAgeAndLeavesNobodyMuchBeyondTheGreatest) {
    double alive = 1.0;
    double before = 0.0;
    for (int age = 0; age < 600; ++age) {
        const double p = background_death(table[spruce], 0.2 * age, age, CanopyPlace{}, {}, !storms);
        EXPECT_GE(p, before);
        before = p;
        alive *= 1.0 - p;
        if (age == 100) {
            EXPECT_GT(alive, std::pow(1.0 - 0.0077, 100)) << "more than at the constant rate of gap models";
        }
    }
    EXPECT_LT(alive, 0.05);
}

TEST(StressDeath, IsHigherForLightDemandingSpecies) {
    const MortalityLaw law;
    EXPECT_DOUBLE_EQ(stress_death(table[*table.find("abal")].light, law), 0.04);
    EXPECT_NEAR(stress_death(table[spruce].light, law), 0.094, 1e-9);
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
    const Stand stand = spruces({0.5, 0.02, 0.06, 0.5}, 2);
    const std::vector<std::uint16_t> years =
        stress_years_after(stand, table, {}, std::vector<std::uint32_t>(4, 0), 1);
    // Mean 0.27 cm: below 0.03 cm is bad, 0.06 cm is above 0.136 of the mean, the least of spruce.
    EXPECT_EQ(years, (std::vector<std::uint16_t>{0, 3, 0, 0}));
}

TEST(StressYears, ComeWithATenthOfTheGrowthOfOthers) {
    const Stand stand = spruces({1.0, 1.0, 0.05}, 0);
    EXPECT_EQ(stress_years_after(stand, table, {}, std::vector<std::uint32_t>(3, 0), 1)[2], 1U);
    // In a unit of its own it is the measure of itself.
    EXPECT_EQ(stress_years_after(stand, table, {}, std::vector<std::uint32_t>{0, 0, 1}, 2)[2], 0U);
}

TEST(StressYears, ComeSoonerToLightDemandingSpecies) {
    // Suppressed larches, pines and birches never died: none had less than a tenth of the mean growth.
    const auto years_of = [](const char* code) {
        const SpeciesId kind = *table.find(code);
        std::vector<Tree> trees;
        for (std::size_t i = 0; i < 3; ++i) {
            Tree tree = new_tree(table[kind], kind, 5.0, 5.0, 20.0, 15.0, 60.0);
            tree.id = TreeId{i};
            tree.increments_cm[0] = i == 0 ? 0.04 : 0.4;
            trees.push_back(tree);
        }
        const Stand stand{square_of_forest(1), table.size(), trees, 2000};
        return stress_years_after(stand, table, {}, std::vector<std::uint32_t>(3, 0), 1)[0];
    };
    EXPECT_EQ(years_of("lade"), 1U);
    EXPECT_EQ(years_of("bepe"), 1U);
    EXPECT_EQ(years_of("abal"), 0U);
}

TEST(NaturalDeaths, ComeAsOftenAsTheirChanceSays) {
    const Stand stand = spruces(std::vector<double>(20'000, 0.0), 3);
    MortalityLaw law;
    law.background = false;
    const auto deaths = static_cast<double>(natural_deaths(stand, table, law, false, {}, {}, 1, 0).size());
    const double p = stress_death(table[spruce].light, law);
    EXPECT_NEAR(deaths / 20'000.0, p, 4.0 * std::sqrt(p * (1.0 - p) / 20'000.0));
}

TEST(NaturalDeaths, NeedThreeBadYears) {
    MortalityLaw law;
    law.background = false;
    law.suppression.in_full_shade = 0.0;
    law.suppression.by_class = 0.0;
    EXPECT_TRUE(
        natural_deaths(spruces(std::vector<double>(1000, 0.0), 2), table, law, false, {}, {}, 1, 0).empty());
}

TEST(NaturalDeaths, FollowTheFactorOnAllOfThem) {
    const Stand stand = spruces(std::vector<double>(4000, 0.0), 3);
    const auto deaths = [&](double factor) {
        return static_cast<double>(natural_deaths(stand, table, {.all = factor}, false, {}, {}, 1, 0).size());
    };
    EXPECT_EQ(deaths(0.0), 0.0);
    // Ratio of two binomial counts of about 400 and 800, four standard errors.
    EXPECT_NEAR(deaths(2.0) / deaths(1.0), 2.0, 4.0 * 2.0 * std::sqrt(1.0 / 400.0 + 1.0 / 800.0));
}

}  // namespace
}  // namespace forest::mortality_test
