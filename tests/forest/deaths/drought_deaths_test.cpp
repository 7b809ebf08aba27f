#include "forest/deaths/drought_deaths.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "forest/deaths/mortality.hpp"
#include "tests/forest/small_forest.hpp"

namespace forest::drought_deaths_test {
namespace {

const DroughtDeaths a_tenth{.at_full_drought = 0.1};

TEST(DroughtDeath, BeginsAtTheToleratedDroughtAndRisesFasterThanInProportion) {
    EXPECT_EQ(drought_death(1.0, a_tenth), 0.0);
    EXPECT_EQ(drought_death(1.0 - tolerated_drought, a_tenth), 0.0);
    EXPECT_NEAR(drought_death(0.5 * (1.0 - tolerated_drought), a_tenth), 0.1 * std::pow(0.5, 1.5), 1e-12);
    EXPECT_NEAR(drought_death(0.75 * (1.0 - tolerated_drought), a_tenth), 0.1 * std::pow(0.25, 1.5), 1e-12);
    EXPECT_NEAR(drought_death(0.0, a_tenth), 0.1, 1e-12);
    EXPECT_EQ(drought_death(0.0, {}), 1.0) << "without any water nobody lives";
}

TEST(NaturalDeaths, CountThoseOfDrought) {
    const SmallForest forest{square_of_forest(6)};
    const Stand stand{forest.grid, forest.species.size(), mixed_stand(forest, 1500.0, 1), 2000};
    MortalityLaw law;
    law.background = false;
    law.stress = false;
    const std::vector<double> chances(stand.trees().size(), 0.3);
    std::size_t stems = 0;
    for (const Tree& tree : stand.trees()) {
        stems += tree.stems;
    }
    std::size_t died = 0;
    for (const Removal& removal : natural_deaths(stand, forest.species, law, false, {}, chances, 1, 0)) {
        EXPECT_EQ(removal.cause, Cause::drought);
        died += removal.stems;
    }
    const auto n = static_cast<double>(stems);
    EXPECT_NEAR(static_cast<double>(died), 0.3 * n, 4.0 * std::sqrt(n * 0.3 * 0.7));
}

TEST(DroughtDeathChances, FollowSpeciesAndPatch) {
    const SmallForest forest{square_of_forest(6)};
    const Stand stand{forest.grid, forest.species.size(), mixed_stand(forest, 500.0, 1), 2000};
    SpeciesDrought drought{forest.grid.size(), forest.species.size()};
    const Tree& first = stand.trees().front();
    drought.set(first.patch, first.species, 0.0);
    const std::vector<double> chances = drought_death_chances(stand, drought, a_tenth);
    ASSERT_EQ(chances.size(), stand.trees().size());
    for (std::size_t i = 0; i < chances.size(); ++i) {
        const Tree& tree = stand.trees()[i];
        const bool is_dry = tree.patch == first.patch && tree.species == first.species;
        EXPECT_NEAR(chances[i], is_dry ? 0.1 : 0.0, 1e-12) << i;
    }
}

}  // namespace
}  // namespace forest::drought_deaths_test
