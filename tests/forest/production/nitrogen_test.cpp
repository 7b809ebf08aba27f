#include "forest/production/nitrogen.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace forest::nitrogen_test {
namespace {

TEST(NitrogenResponse, IsLowerForDemandingSpecies) {
    EXPECT_NEAR(nitrogen_response(1.0, 60.0), 1.0 - std::exp(-0.045 * 50.0), 1e-9);
    EXPECT_NEAR(nitrogen_response(3.0, 60.0), 1.0 - std::exp(-0.065 * 20.0), 1e-9);
    EXPECT_NEAR(nitrogen_response(2.2, 60.0), 1.0 - std::exp(-0.057 * 32.0), 1e-9);
    EXPECT_EQ(nitrogen_response(3.0, 30.0), 0.0);
}

TEST(NitrogenAdvantage, IsThatOfFrugalSpeciesOnPoorSoil) {
    for (const double nitrogen_kg : {0.0, 30.0, 50.0, 60.0, 70.0}) {
        EXPECT_GT(nitrogen_advantage(1.0, nitrogen_kg), nitrogen_advantage(1.5, nitrogen_kg)) << nitrogen_kg;
        EXPECT_GT(nitrogen_advantage(1.5, nitrogen_kg), 1.0) << nitrogen_kg;
        EXPECT_EQ(nitrogen_advantage(2.0, nitrogen_kg), 1.0) << nitrogen_kg;
        EXPECT_LT(nitrogen_advantage(2.5, nitrogen_kg), 1.0) << nitrogen_kg;
    }
}

TEST(NitrogenAdvantage, EndsWhereThereIsPlenty) {
    for (const double nitrogen_class : {1.0, 1.5, 2.2, 2.5, 3.0}) {
        EXPECT_NEAR(nitrogen_advantage(nitrogen_class, 120.0), 1.0, 0.002) << nitrogen_class;
    }
}

}  // namespace
}  // namespace forest::nitrogen_test
