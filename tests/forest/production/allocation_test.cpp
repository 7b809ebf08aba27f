#include "forest/production/allocation.hpp"

#include <gtest/gtest.h>

namespace forest::allocation_test {
namespace {

TEST(RootShare, RunsFromTheHighestOnBadSitesToTheLowestOnGood) {
    EXPECT_DOUBLE_EQ(root_share({0.2, 0.7}, 0.0, 1.0), 0.7);
    EXPECT_DOUBLE_EQ(root_share({0.2, 0.7}, 1.0, 0.0), 0.7);
    EXPECT_DOUBLE_EQ(root_share({0.2, 0.7}, 1.0, 1.0), 0.2);
    EXPECT_GT(root_share({0.2, 0.7}, 0.3, 0.5), root_share({0.2, 0.7}, 0.6, 0.5));
}

TEST(FoliageToStemLaw, PassesThroughItsTwoPoints) {
    const FoliageToStemLaw law{{0.8297, 0.148}};
    EXPECT_NEAR(law.at(2.0), 0.8297, 1e-12);
    EXPECT_NEAR(law.at(20.0), 0.148, 1e-12);
}

TEST(Litterfall, RunsFromTheInitialToTheMatureRate) {
    const Litterfall law{0.027, 0.001, 12.0};
    EXPECT_NEAR(litterfall_pmonth(0.0, law), 0.001, 1e-12);
    EXPECT_NEAR(litterfall_pmonth(1.0, law), 0.5 * 0.027 * (1.0 + 0.001 / (0.027 + 0.001)), 0.001);
    EXPECT_NEAR(litterfall_pmonth(100.0, law), 0.027, 1e-12);
    EXPECT_DOUBLE_EQ(litterfall_pmonth(50.0, {0.0, 0.001, 12.0}), 0.0);
    EXPECT_DOUBLE_EQ(litterfall_pmonth(50.0, {0.02, 0.001, 0.0}), 0.02);
}

TEST(ByAge, IsHalfWayAtItsAge) {
    EXPECT_NEAR(by_age(35.0, 24.0, 18.0, 35.0, 2.0), 21.0, 1e-12);
    EXPECT_NEAR(by_age(0.0, 24.0, 18.0, 35.0, 2.0), 24.0, 1e-12);
    EXPECT_NEAR(by_age(1000.0, 24.0, 18.0, 35.0, 1.0), 18.0, 1e-6);
    EXPECT_DOUBLE_EQ(by_age(5.0, 24.0, 18.0, 0.0, 1.0), 18.0);
}

TEST(ByAge, StaysBetweenItsValuesAtAnyAge) {
    // Published sets of birch, cembra pine and Scots pine have a half-way age of 1 year, so the exponential
    // underflows at the age of 32 years.
    for (const double power_of_age : {1.0, 2.0, 3.0}) {
        double before = 24.0;
        for (int year = 0; year <= 1000; ++year) {
            const double value = by_age(year, 24.0, 18.0, 1.0, power_of_age);
            ASSERT_GE(value, 18.0) << year;
            ASSERT_LE(value, before) << year;
            before = value;
        }
        EXPECT_DOUBLE_EQ(before, 18.0);
    }
}

}  // namespace
}  // namespace forest::allocation_test
