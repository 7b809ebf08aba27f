#include "coupling/inputs/places/line_through.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <utility>

namespace coupling::line_through_test {
namespace {

using Line = std::vector<Eigen::Vector2d>;

rockfall::Target house() {
    rockfall::Target target;
    target.id = "house";
    target.is_area = true;
    target.parts = {{{10, 10}, {20, 10}, {20, 20}, {10, 20}, {10, 10}}};
    return rockfall::with_bounds(target);
}

rockfall::Target road() {
    rockfall::Target target;
    target.id = "road";
    target.parts = {{{0, 15}, {100, 15}}};
    return rockfall::with_bounds(target);
}

TEST(RunsOver, IsThroughTheAreaFromEndToEndAcrossACornerOrWithinIt) {
    EXPECT_TRUE(runs_over(Line{{0, 15}, {30, 15}}, house()));
    EXPECT_TRUE(runs_over(Line{{0, 15}, {15, 15}}, house()));
    EXPECT_TRUE(runs_over(Line{{17, 8}, {22, 13}}, house())) << "over a corner";
    EXPECT_FALSE(runs_over(Line{{19, 8}, {22, 11}}, house())) << "past the corner";
    EXPECT_TRUE(runs_over(Line{{12, 12}, {18, 18}}, house())) << "wholly within";
    EXPECT_FALSE(runs_over(Line{{0, 9}, {30, 9}}, house()));
    EXPECT_FALSE(runs_over(Line{}, house()));
    EXPECT_TRUE(runs_over(Line{{50, 0}, {50, 30}}, road()));
    EXPECT_FALSE(runs_over(Line{{50, 16}, {50, 30}}, road()));
}

TEST(RunsAcross, IsBeyondBothSidesOfALineHoweverBothAreTurned) {
    for (const double turn_deg : {0.0, 30.0, 77.0, 145.0}) {
        const double turn_rad = turn_deg * std::numbers::pi / 180.0;
        const auto turned = [&](Line line) {
            for (Eigen::Vector2d& point : line) {
                point = Eigen::Rotation2Dd{turn_rad} * point;
            }
            return line;
        };
        rockfall::Target way = road();
        way.parts.front() = turned(way.parts.front());
        way = rockfall::with_bounds(way);
        for (const bool is_reversed : {false, true}) {
            const auto across = [&](Line line) {
                line = turned(std::move(line));
                if (is_reversed) {
                    std::reverse(line.begin(), line.end());
                }
                return runs_across(line, way);
            };
            EXPECT_TRUE(across({{50, 0}, {50, 30}})) << turn_deg;
            EXPECT_TRUE(across({{50, 0}, {50, 15}, {50, 30}})) << "with a corner on it";
            EXPECT_TRUE(across({{40, 5}, {60, 25}}));
            EXPECT_FALSE(across({{50, 16}, {50, 30}})) << "beside it";
            EXPECT_FALSE(across({{50, 14.5}, {50, 30}})) << "ends at it";
            EXPECT_FALSE(across({{0, 14.9}, {100, 15.1}})) << "a mark along it";
            EXPECT_FALSE(across({{120, 0}, {120, 30}})) << "past its end";
        }
    }
    EXPECT_FALSE(runs_across(Line{{0, 15}, {30, 15}}, house()));
    EXPECT_FALSE(runs_across(Line{}, road()));
}

TEST(IsHouse, IsAnAreaUpToTwoThousandSquareMetres) {
    EXPECT_TRUE(is_house(house()));
    EXPECT_FALSE(is_house(road()));
    rockfall::Target zone = house();
    zone.parts = {{{0, 0}, {50, 0}, {50, 41}, {0, 41}, {0, 0}}};
    EXPECT_FALSE(is_house(rockfall::with_bounds(zone))) << "2050 m2";
    zone.parts = {{{0, 0}, {50, 0}, {50, 39}, {0, 39}, {0, 0}}};
    EXPECT_TRUE(is_house(rockfall::with_bounds(zone)));
}

TEST(CoversPart, IsAnyOverlapAlsoOfOneInsideTheOther) {
    const auto box = [](double west, double south, double side) {
        return Line{{west, south},
                    {west + side, south},
                    {west + side, south + side},
                    {west, south + side},
                    {west, south}};
    };
    EXPECT_TRUE(covers_part(box(0, 0, 40), house())) << "the house lies wholly in the ring";
    EXPECT_TRUE(covers_part(box(12, 12, 2), house())) << "the ring lies wholly in the house";
    EXPECT_TRUE(covers_part(box(15, 15, 20), house()));
    EXPECT_FALSE(covers_part(box(21, 21, 5), house()));
    EXPECT_FALSE(covers_part(Line{}, house())) << "a work that could not be placed";
    EXPECT_TRUE(covers_part(box(40, 10, 10), road()));
    EXPECT_TRUE(covers_part(box(-10, -10, 200), road()));
    EXPECT_FALSE(covers_part(box(40, 20, 10), road()));
}

}  // namespace
}  // namespace coupling::line_through_test
