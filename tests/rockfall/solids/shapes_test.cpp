#include "rockfall/solids/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rockfall/solids/mass_properties.hpp"

namespace rockfall::solids::shapes_test {
namespace {

TEST(Shapes, HaveTheVolumeOfTheirFormula) {
    EXPECT_NEAR(volume_integrals(box({1.0, 2.0, 3.0})).volume_m3, 6.0, 1e-14);
    // Two pyramids of a third of base times height each.
    EXPECT_NEAR(volume_integrals(double_pyramid({2.0, 2.0, 20.0})).volume_m3, 80.0 / 3.0, 1e-13);
    // A cube of side 2 without twelve prisms of cross-section c^2 / 2. At each corner three of them meet: two
    // share c^3 / 3, all three c^3 / 4 (inclusion and exclusion).
    const double c = 0.25;
    const double pairwise = c * c * c / 3.0, all_three = c * c * c / 4.0;
    EXPECT_NEAR(volume_integrals(chamfered_box({2.0, 2.0, 2.0}, c)).volume_m3,
                8.0 - 12.0 * 2.0 * c * c / 2.0 + 8.0 * (3.0 * pairwise - all_three), 1e-13);
    EXPECT_NEAR(volume_integrals(with_volume(box({1.0, 2.0, 3.0}), 0.7)).volume_m3, 0.7, 1e-10);
}

TEST(Shapes, HaveFacesAsTheyShould) {
    EXPECT_EQ(chamfered_box({1.0, 2.0, 3.0}, 0.2).faces.size(), 18U);
    EXPECT_EQ(double_pyramid({1.0, 1.0, 2.0}).faces.size(), 8U);
    EXPECT_EQ(ellipsoid({1.0, 1.0, 1.0}, 2).vertices_m.size(), 162U);
}

TEST(FormClass, FollowsTheTriangleOfSneedAndFolk) {
    EXPECT_EQ(form_class({1.0, 1.0, 1.0}), FormClass::compact);
    EXPECT_EQ(form_class({0.6, 1.0, 1.0}), FormClass::compact_platy);
    EXPECT_EQ(form_class({1.0, 0.8, 0.6}), FormClass::compact_bladed);
    EXPECT_EQ(form_class({0.6, 0.6, 1.0}), FormClass::compact_elongate);
    EXPECT_EQ(form_class({1.0, 1.0, 0.4}), FormClass::platy);
    EXPECT_EQ(form_class({1.0, 0.7, 0.4}), FormClass::bladed);
    EXPECT_EQ(form_class({0.4, 1.0, 0.4}), FormClass::elongate);
    EXPECT_EQ(form_class({1.0, 0.95, 0.1}), FormClass::very_platy);
    EXPECT_EQ(form_class({1.0, 0.55, 0.1}), FormClass::very_bladed);
    EXPECT_EQ(form_class({0.1, 0.1, 1.0}), FormClass::very_elongate);
    EXPECT_EQ(name_of(FormClass::very_elongate), "very-elongate");
    EXPECT_EQ(name_of(FormClass::compact), "compact");
}

}  // namespace
}  // namespace rockfall::solids::shapes_test
