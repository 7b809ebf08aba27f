#include "forest/start/diameter_of_height.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace forest::diameter_of_height_test {
namespace {

TEST(DiameterOfHeight, IsThatOfTheFitOnTheMedian) {
    EXPECT_NEAR(diameter_of_conifer.dbh_cm(20.0, 0.0), 1.28 * std::pow(20.0, 1.085), 1e-9);
    EXPECT_NEAR(diameter_of_broadleaf.dbh_cm(20.0, 0.0), 1.11 * std::pow(20.0, 1.032), 1e-9);
}

RC_GTEST_PROP(DiameterOfHeight, RisesWithHeightAndChance, ()) {
    const double height_m = 0.1 * *rc::gen::inRange(15, 500);
    const double normal = 0.01 * *rc::gen::inRange(-300, 300);
    for (const DiameterOfHeight& law : {diameter_of_conifer, diameter_of_broadleaf}) {
        const double dbh_cm = law.dbh_cm(height_m, normal);
        RC_ASSERT(law.dbh_cm(height_m + 0.1, normal) > dbh_cm);
        RC_ASSERT(law.dbh_cm(height_m, normal + 0.1) > dbh_cm);
        RC_ASSERT(std::abs(std::log(dbh_cm / law.dbh_cm(height_m, 0.0)) - law.spread * normal) < 1e-9);
    }
}

}  // namespace
}  // namespace forest::diameter_of_height_test
