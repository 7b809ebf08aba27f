#include "forest/stand/allometry.hpp"

#include <gtest/gtest.h>

namespace forest::allometry_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const Species& spruce = table[*table.find("piab")];

TEST(Allometry, GivesThePublishedLeavesOfAThickSpruce) {
    // 0.0956 * 30^1.56 = 19.3 kg; with 6.7 m2/kg, which closed stands need to hold 6 to 8 m2/m2, 129 m2.
    EXPECT_NEAR(part_masses(spruce.allometry, 30.0, 28.0, 1.0).foliage_kg, 19.3, 0.1);
    EXPECT_NEAR(leaf_area_m2(spruce, 30.0, 1.0), 129.0, 0.5);
}

TEST(BasalArea, IsThatOfACircle) {
    // pi / 4 * (0.2 m)^2
    EXPECT_NEAR(basal_area_m2(20.0), 0.0314159265, 1e-9);
}

TEST(StemVolume, IsTheFormFactorOfACylinder) {
    EXPECT_NEAR(stem_volume_m3(spruce.allometry, 20.0, 18.0),
                spruce.allometry.form_factor * basal_area_m2(20.0) * 18.0, 1e-12);
}

}  // namespace
}  // namespace forest::allometry_test
