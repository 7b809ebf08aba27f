#include "forest/height_growth.hpp"

#include <gtest/gtest.h>

namespace forest::height_growth_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const Species& spruce = table[*table.find("piab")];

TEST(HeightDiameterRatio, IsLargerInShade) {
    EXPECT_GT(height_diameter_ratio(spruce.height_growth, 20.0, 0.2, 1.0),
              height_diameter_ratio(spruce.height_growth, 20.0, 0.8, 1.0));
}

TEST(HeightDiameterRatio, LiesOnItsTwoCurvesInFullLightAndInDeepShade) {
    const HeightGrowth& law = spruce.height_growth;
    // At 1 cm a power law is its factor.
    EXPECT_NEAR(height_diameter_ratio(law, 1.0, 1.0, 1.0), law.ratio_low.factor, 1e-9);
    EXPECT_NEAR(height_diameter_ratio(law, 1.0, 0.0, 1.0), law.ratio_high.factor, 1e-9);
    EXPECT_NEAR(height_diameter_ratio(law, 1.0, 0.5, 1.0),
                0.5 * (law.ratio_low.factor + law.ratio_high.factor), 1e-9);
}

TEST(SiteHeightFactor, RisesWithWarmthTowards131) {
    const HeightGrowth& law = spruce.height_growth;
    EXPECT_DOUBLE_EQ(site_height_factor(law, 0.0), 0.0);
    EXPECT_NEAR(site_height_factor(law, law.degree_days_tau), 1.31 * 0.6321205588, 1e-9);
    EXPECT_NEAR(site_height_factor(law, 50.0 * law.degree_days_tau), 1.31, 1e-9);
}

}  // namespace
}  // namespace forest::height_growth_test
