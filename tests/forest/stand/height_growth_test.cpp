#include "forest/stand/height_growth.hpp"

#include <gtest/gtest.h>

#include <cmath>

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
    const double low = law.ratio_low.factor * std::pow(20.0, law.ratio_low.exponent);
    const double high = law.ratio_high.factor * std::pow(20.0, law.ratio_high.exponent);
    EXPECT_NEAR(height_diameter_ratio(law, 20.0, 1.0, 1.0), low, 1e-9 * low);
    EXPECT_NEAR(height_diameter_ratio(law, 20.0, 0.0, 1.0), high, 1e-9 * high);
    EXPECT_NEAR(height_diameter_ratio(law, 20.0, 0.5, 1.0), 0.5 * (low + high), 1e-9 * high);
}

TEST(HeightDiameterRatio, OfATreeOfACentimetreIsThatOfFour) {
    EXPECT_DOUBLE_EQ(height_diameter_ratio(spruce.height_growth, 1.0, 0.5, 1.0),
                     height_diameter_ratio(spruce.height_growth, 4.0, 0.5, 1.0));
    EXPECT_GT(height_diameter_ratio(spruce.height_growth, 4.0, 0.5, 1.0),
              height_diameter_ratio(spruce.height_growth, 5.0, 0.5, 1.0));
}

TEST(SiteHeightFactor, RisesWithWarmthTowardsItsGreatestValue) {
    const HeightGrowth& law = spruce.height_growth;
    EXPECT_DOUBLE_EQ(site_height_factor(law, 0.0), 0.0);
    EXPECT_NEAR(site_height_factor(law, law.degree_days_tau), 1.37 * 0.6321205588, 1e-9);
    EXPECT_NEAR(site_height_factor(law, 50.0 * law.degree_days_tau), 1.37, 1e-9);
}

}  // namespace
}  // namespace forest::height_growth_test
