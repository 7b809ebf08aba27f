#include "coupling/assessments/collapse/floor_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace coupling::collapse {
namespace {

using Eigen::Vector2d;

rockfall::Target area_of(std::vector<std::vector<Vector2d>> rings) {
    rockfall::Target target;
    target.is_area = true;
    target.parts = std::move(rings);
    return rockfall::with_bounds(target);
}

std::vector<Vector2d> rectangle(const Vector2d& low, const Vector2d& high) {
    return {low, {high.x(), low.y()}, high, {low.x(), high.y()}, low};
}

TEST(FloorWatch, HasTheFloorOfARectangleAndOfOneWithAYard) {
    EXPECT_NEAR(FloorWatch{area_of({rectangle({100.0, 50.0}, {120.0, 60.0})})}.floor_m2(), 200.0, 1e-9);
    EXPECT_NEAR(
        (FloorWatch{area_of({rectangle({0.0, 0.0}, {20.0, 20.0}), rectangle({5.0, 5.0}, {15.0, 15.0})})}
             .floor_m2()),
        300.0, 1e-9);
    // Turned by 30 degrees: cells along the walls count whole or not at all, 1 % of the floor at most.
    const double c = std::cos(std::numbers::pi / 6.0), s = 0.5;
    const auto turned = [&](double x, double y) { return Vector2d{c * x - s * y, s * x + c * y}; };
    EXPECT_NEAR(
        FloorWatch{area_of({{turned(0, 0), turned(20, 0), turned(20, 10), turned(0, 10), turned(0, 0)}})}
            .floor_m2(),
        200.0, 2.0);
}

TEST(FloorWatch, HasNoFloorForALine) {
    rockfall::Target line;
    line.parts = {{{0.0, 0.0}, {10.0, 10.0}}};
    FloorWatch floor{rockfall::with_bounds(line)};
    floor.pass({0.0, 0.0}, {10.0, 10.0}, 2.0, 1e6);
    EXPECT_EQ(floor.floor_m2(), 0.0);
    EXPECT_EQ(floor.reached_m2(0.0), 0.0);
}

TEST(FloorWatch, CountsTheStripsThatBlocksCoverByTheirLargestEnergy) {
    FloorWatch floor{area_of({rectangle({0.0, 0.0}, {10.0, 10.0})})};
    EXPECT_EQ(floor.reached_m2(0.0), 0.0);
    // Two strips of 2 x 10 m that cross each other: the second one with more energy.
    floor.pass({-5.0, 5.0}, {15.0, 5.0}, 1.0, 50e3);
    EXPECT_NEAR(floor.reached_m2(0.0), 20.0, 0.01);
    floor.pass({5.0, -5.0}, {5.0, 15.0}, 1.0, 400e3);
    EXPECT_NEAR(floor.reached_m2(0.0), 36.0, 0.01);
    EXPECT_NEAR(floor.reached_m2(30e3), 36.0, 0.01);
    EXPECT_NEAR(floor.reached_m2(300e3), 20.0, 0.01);
    // What comes later with less changes nothing, and what passes beside reaches nothing.
    floor.pass({-5.0, 5.0}, {15.0, 5.0}, 1.0, 1e3);
    floor.pass({-5.0, 11.5}, {15.0, 11.5}, 1.0, 1e6);
    EXPECT_NEAR(floor.reached_m2(0.0), 36.0, 0.01);
    EXPECT_NEAR(floor.reached_m2(300e3), 20.0, 0.01);
    EXPECT_EQ(floor.reached_m2(500e3), 0.0);
}

TEST(FloorWatch, ReachesADiscUnderABlockAtRest) {
    FloorWatch floor{area_of({rectangle({0.0, 0.0}, {10.0, 10.0})})};
    floor.pass({5.0, 5.0}, {5.0, 5.0}, 2.0, 1.0);
    EXPECT_NEAR(floor.reached_m2(0.0), std::numbers::pi * 4.0, 0.15);
}

TEST(WallMet, IsTheOneThatAWayCrossesFirstOrElseTheNearest) {
    const rockfall::Target house = area_of({rectangle({0.0, 0.0}, {10.0, 6.0})});
    ASSERT_EQ(walls_of(house).size(), 4U);
    EXPECT_DOUBLE_EQ(walls_of(house)[0].length_m(), 10.0);
    EXPECT_EQ(wall_met(house, {5.0, -1.0}, {5.0, 1.0}), 0U);   // south
    EXPECT_EQ(wall_met(house, {12.0, 3.0}, {-2.0, 3.0}), 1U);  // through the house from the east
    EXPECT_EQ(wall_met(house, {-2.0, 3.0}, {12.0, 3.0}), 3U);  // and from the west
    EXPECT_EQ(wall_met(house, {4.0, 9.0}, {4.0, 6.5}), 2U);    // stops in front of the northern one
    EXPECT_EQ(wall_met(house, {-3.0, 2.0}, {-0.5, 2.0}), 3U);  // and of the western one
}

}  // namespace
}  // namespace coupling::collapse
