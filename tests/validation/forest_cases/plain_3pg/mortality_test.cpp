#include "validation/engine/forest_cases/plain_3pg/mortality.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace coupling::validation::forest_cases::plain_3pg::mortality_test {
namespace {

const SelfThinning limit{400.0, 1.5};

TEST(SelfThinning, LeavesTheStandOnItsLimit) {
    for (const double lost : {0.0, 0.2, 0.4, 0.8}) {
        const double stems_pha = 2000.0;
        const double stem_tpha = 300.0;  // 150 kg a tree, where the limit is 141
        const double dead_pha = self_thinned_pha(stems_pha, stem_tpha, lost, limit);
        EXPECT_GT(dead_pha, 0.0);
        const double left_pha = stems_pha - dead_pha;
        const double left_kg = 1000.0 * stem_tpha * (1.0 - lost * dead_pha / stems_pha) / left_pha;
        // Newton's last step is below one tree.
        EXPECT_NEAR(left_kg / (400.0 * std::pow(1000.0 / left_pha, 1.5)), 1.0, 1e-4) << lost;
    }
}

TEST(SelfThinning, TakesMoreTreesWhereTheDyingAreSmall) {
    EXPECT_GT(self_thinned_pha(2000.0, 300.0, 0.2, limit), 0.0);
    EXPECT_LT(self_thinned_pha(2000.0, 300.0, 0.8, limit),
              self_thinned_pha(2000.0, 300.0, 0.0, limit) * 10.0);
}

}  // namespace
}  // namespace coupling::validation::forest_cases::plain_3pg::mortality_test
