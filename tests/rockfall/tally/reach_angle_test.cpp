#include "rockfall/tally/reach_angle.hpp"

#include <gtest/gtest.h>

#include "tests/rockfall/slopes.hpp"

namespace rockfall::reach_angle_test {
namespace {

using Eigen::Vector2d;

/// A face of 60 deg from 100 to 130 m, a talus of 35 deg to 200 m, level ground beyond.
double face_and_talus_m(double x_m) {
    const double face = std::tan(config::Angle::from_degrees(60.0).in_radians());
    const double talus = std::tan(config::Angle::from_degrees(35.0).in_radians());
    return 500.0 - face * std::clamp(x_m - 100.0, 0.0, 30.0) - talus * std::clamp(x_m - 130.0, 0.0, 70.0);
}

/// 260 m along the fall line, 60 m across.
Terrain terrain_of(double cell_m, const std::function<double(double, double)>& height_m) {
    const auto cells = [&](double length_m) { return static_cast<int>(std::lround(length_m / cell_m)); };
    return triangulate(testing::heights_of({cells(260.0), cells(60.0), 0.0, 0.0, cell_m, cell_m}, height_m),
                       0.0);
}

Terrain cliff(double cell_m) {
    return terrain_of(cell_m, [](double x_m, double) { return face_and_talus_m(x_m); });
}

TEST(ReachAngle, IsThatOfTheStraightLineFromStartToStop) {
    const Terrain terrain = cliff(1.0);
    const auto angles = reach_angles(terrain, {110.0, 30.0}, {230.0, 30.0});
    ASSERT_TRUE(angles);
    EXPECT_NEAR(angles->fall_m, face_and_talus_m(110.0) - face_and_talus_m(230.0), 0.1);
    EXPECT_NEAR(angles->reach.in_degrees(),
                config::Angle::from_radians(std::atan2(angles->fall_m, 120.0)).in_degrees(), 1e-9);
    const auto aslant = reach_angles(terrain, {110.0, 5.0}, {230.0, 55.0});
    ASSERT_TRUE(aslant);
    EXPECT_NEAR(aslant->reach.in_degrees(),
                config::Angle::from_radians(std::atan2(angles->fall_m, 130.0)).in_degrees(), 0.01);
}

TEST(ReachAngle, OfTheShadowIsThatFromTheTopOfTheTalus) {
    const auto angles = reach_angles(cliff(1.0), {110.0, 30.0}, {230.0, 30.0});
    ASSERT_TRUE(angles);
    ASSERT_TRUE(angles->shadow);
    const double apex_m = 130.0;
    EXPECT_NEAR(
        angles->shadow->in_degrees(),
        config::Angle::from_radians(std::atan2(face_and_talus_m(apex_m) - face_and_talus_m(230.0), 100.0))
            .in_degrees(),
        0.7)
        << "the slope is measured over 10 m, so the top of the talus is found within a few metres";
}

TEST(ReachAngle, HardlyDependsOnTheCells) {
    const auto fine = reach_angles(cliff(1.0), {105.0, 30.0}, {215.0, 25.0});
    const auto coarse = reach_angles(cliff(5.0), {105.0, 30.0}, {215.0, 25.0});
    ASSERT_TRUE(fine && coarse && fine->shadow && coarse->shadow);
    EXPECT_NEAR(fine->reach.in_degrees(), coarse->reach.in_degrees(), 0.3);
    EXPECT_NEAR(fine->shadow->in_degrees(), coarse->shadow->in_degrees(), 1.0);
}

TEST(ReachAngle, TakesNoBoulderForACliff) {
    // A step of 2 m on the talus, steep over one cell.
    const auto with_step = [](double x_m, double) {
        return face_and_talus_m(x_m) - (x_m > 170.0 ? 2.0 : 0.0);
    };
    const auto angles = reach_angles(terrain_of(1.0, with_step), {110.0, 30.0}, {230.0, 30.0});
    ASSERT_TRUE(angles && angles->shadow);
    EXPECT_GT(angles->shadow->in_degrees(), 26.0) << "measured from the step it would be about 18 degrees";
    CliffRule rule;
    rule.over_m = 2.0;
    const auto over_a_cell = reach_angles(terrain_of(1.0, with_step), {110.0, 30.0}, {230.0, 30.0}, rule);
    ASSERT_TRUE(over_a_cell && over_a_cell->shadow);
    EXPECT_LT(over_a_cell->shadow->in_degrees(), 25.0);
}

TEST(ReachAngle, OfTheShadowIsThatOfTheStartWithoutACliffBetween) {
    const auto angles = reach_angles(cliff(1.0), {150.0, 30.0}, {230.0, 30.0});
    ASSERT_TRUE(angles && angles->shadow);
    EXPECT_DOUBLE_EQ(angles->shadow->in_degrees(), angles->reach.in_degrees());
}

TEST(ReachAngle, HasNoShadowOnACliffAndNoneOffTheTerrain) {
    const auto on_face = reach_angles(cliff(1.0), {105.0, 30.0}, {120.0, 30.0});
    ASSERT_TRUE(on_face);
    EXPECT_FALSE(on_face->shadow);
    EXPECT_GT(on_face->reach.in_degrees(), 55.0);
    EXPECT_FALSE(reach_angles(cliff(5.0), {105.0, 30.0}, {450.0, 30.0}));
    EXPECT_FALSE(is_cliff(cliff(1.0), {120.0, 2.0}, {})) << "the terrain ends within the length";
}

}  // namespace
}  // namespace rockfall::reach_angle_test
