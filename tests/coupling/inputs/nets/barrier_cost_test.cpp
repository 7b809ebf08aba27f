#include "coupling/inputs/nets/barrier_cost.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace coupling::barrier_cost_test {
namespace {

TEST(AnnualCost, IsTheAnnuityWhosePresentValueIsTheInvestment) {
    for (const double interest_percent : {0.5, 2.0, 5.0}) {
        for (const double years : {1.0, 30.0, 80.0}) {
            const double annuity = annual_cost({250'000.0, years, 0.0}, interest_percent).value();
            double present = 0.0;
            for (int year = 1; year <= static_cast<int>(years); ++year) {
                present += annuity / std::pow(1.0 + 0.01 * interest_percent, year);
            }
            EXPECT_NEAR(present, 250'000.0, 1e-6);
        }
    }
}

TEST(AnnualCost, IsTheEvenShareWithoutInterestAndAddsMaintenance) {
    EXPECT_DOUBLE_EQ(annual_cost({100'000.0, 50.0, 1.5}, 0.0).value(), 2000.0 + 1500.0);
    EXPECT_NEAR(annual_cost({100'000.0, 50.0, 0.0}, 1e-9).value(), 2000.0, 1e-4);
    // 50 years at 2 %: the annuity factor of any table of interest, 0.031823.
    EXPECT_NEAR(annual_cost({1.0, 50.0, 0.0}, 2.0).value(), 0.031823, 5e-7);
}

TEST(AnnualCost, IsNotKnownWithoutInvestmentOrLife) {
    EXPECT_FALSE(annual_cost({}, 2.0));
    EXPECT_FALSE(annual_cost({1000.0, std::nullopt, 0.0}, 2.0));
}

}  // namespace
}  // namespace coupling::barrier_cost_test
