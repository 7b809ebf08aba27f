#include "forest/forest_factors.hpp"

#include <gtest/gtest.h>

#include "tests/forest/small_forest.hpp"

namespace forest::forest_factors_test {
namespace {

TEST(ForestFactors, OfOneChangeNothing) {
    const SpeciesTable species = SpeciesTable::shipped();
    const SpeciesTable same = with_factors(species, {});
    for (std::size_t i = 0; i < species.size(); ++i) {
        EXPECT_EQ(same.all()[i].response.npp_multiplier, species.all()[i].response.npp_multiplier);
        EXPECT_EQ(same.all()[i].seeds.seedlings_pm2, species.all()[i].seeds.seedlings_pm2);
    }
    EXPECT_EQ(with_factors(Parameters{}, {}).mortality.all, 1.0);
}

TEST(ForestFactors, ChangeWhatTheyName) {
    const SpeciesTable species = SpeciesTable::shipped();
    const ForestFactors factors{1.2, 1.5, 0.4};
    const SpeciesTable changed = with_factors(species, factors);
    for (std::size_t i = 0; i < species.size(); ++i) {
        EXPECT_EQ(changed.all()[i].code, species.all()[i].code);
        EXPECT_EQ(changed.all()[i].response.npp_multiplier, 1.2 * species.all()[i].response.npp_multiplier);
        EXPECT_EQ(changed.all()[i].seeds.seedlings_pm2, 0.4 * species.all()[i].seeds.seedlings_pm2);
    }
    EXPECT_EQ(with_factors(Parameters{}, factors).mortality.all, 1.5);
}

}  // namespace
}  // namespace forest::forest_factors_test
