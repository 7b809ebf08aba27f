#include "config/geometry/wkt.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace config::wkt_test {
namespace {

Shape shape_of(const std::string& text) {
    return read_wkt(text, {"targets.csv", 3, 10});
}

std::string message_of(const std::string& text) {
    try {
        shape_of(text);
    } catch (const InputError& error) {
        EXPECT_EQ(error.code(), ExitCode::data);
        return error.what();
    }
    return "";
}

using Parts = std::vector<std::vector<Point2>>;

TEST(ReadWkt, ReadsEachType) {
    EXPECT_EQ(shape_of("POINT (1 2)").parts, (Parts{{{1, 2}}}));
    EXPECT_EQ(shape_of("LINESTRING (1 2, 3.5 -4e1)").parts, (Parts{{{1, 2}, {3.5, -40}}}));
    EXPECT_EQ(shape_of("POLYGON ((0 0, 4 0, 0 4, 0 0), (1 1, 2 1, 1 2, 1 1))").parts,
              (Parts{{{0, 0}, {4, 0}, {0, 4}, {0, 0}}, {{1, 1}, {2, 1}, {1, 2}, {1, 1}}}));
    EXPECT_EQ(shape_of("MULTIPOINT (1 2, 3 4)").parts, (Parts{{{1, 2}}, {{3, 4}}}));
    EXPECT_EQ(shape_of("MULTIPOINT ((1 2), (3 4))").parts, (Parts{{{1, 2}}, {{3, 4}}}));
    EXPECT_EQ(shape_of("MULTILINESTRING ((1 2, 3 4), (5 6, 7 8))").parts,
              (Parts{{{1, 2}, {3, 4}}, {{5, 6}, {7, 8}}}));
    EXPECT_EQ(shape_of("MULTIPOLYGON (((0 0, 4 0, 0 4, 0 0)), ((9 9, 10 9, 9 10, 9 9)))").parts.size(), 2U);
}

TEST(ReadWkt, TakesCoordinatesUpToTheGreatestThatSystemsHave) {
    EXPECT_EQ(message_of("LINESTRING (0 0, 1 1e9)"), "");
}

TEST(ReadWkt, RefusesAShapeWithoutCoordinates) {
    // Tables leave such rows out before.
    EXPECT_EQ(message_of("POINT EMPTY"),
              "targets.csv:3:16: found an empty shape, expected coordinates in brackets; draw the shape, or "
              "delete the row");
}

TEST(ReadWkt, KnowsTheKind) {
    EXPECT_EQ(shape_of("POINT (1 2)").kind, Shape::Kind::point);
    EXPECT_EQ(shape_of("MULTILINESTRING ((1 2, 3 4))").kind, Shape::Kind::line);
    EXPECT_EQ(shape_of("MULTIPOLYGON (((0 0, 4 0, 0 4, 0 0)))").kind, Shape::Kind::polygon);
}

TEST(ReadWkt, TakesAnyCaseSpacingAndDimension) {
    const Parts expected{{{1, 2}, {3, 4}}};
    for (const char* text :
         {"linestring(1 2,3 4)", " LineString  ( 1\t2 ,\n3 4 ) ", "LINESTRING Z (1 2 9, 3 4 9)",
          "LINESTRINGZ(1 2 9,3 4 9)", "LINESTRING ZM (1 2 9 8, 3 4 9 8)", "LINESTRING M(1 2 0,3 4 5)",
          "LINESTRING (1 2 9, 3 4)"}) {
        EXPECT_EQ(shape_of(text).parts, expected) << text;
    }
}

TEST(ReadWkt, RefusesEveryTextCutShort) {
    const std::string whole = "MULTIPOLYGON (((0 0, 4 0, 0 4, 0 0), (1 1, 2 1, 1 2, 1 1)))";
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_NE(message_of(whole.substr(0, size)), "") << whole.substr(0, size);
    }
}

TEST(ReadWkt, TakesCurvesWithoutArcsAsLinesAndPolygons) {
    EXPECT_EQ(shape_of("COMPOUNDCURVE ((1 2, 3 4), (3 4, 5 6))").parts, (Parts{{{1, 2}, {3, 4}, {5, 6}}}));
    EXPECT_EQ(shape_of("MULTICURVE ((1 2, 3 4), COMPOUNDCURVE ((5 6, 7 8)))").parts,
              (Parts{{{1, 2}, {3, 4}}, {{5, 6}, {7, 8}}}));
    const Shape surface = shape_of(
        "MULTISURFACE (((0 0, 4 0, 0 4, 0 0)), CURVEPOLYGON ((9 9, 10 9, 9 10, 9 9)), "
        "CURVEPOLYGON (COMPOUNDCURVE ((5 5, 6 5), (6 5, 5 6, 5 5))))");
    EXPECT_EQ(surface.kind, Shape::Kind::polygon);
    EXPECT_EQ(surface.parts, (Parts{{{0, 0}, {4, 0}, {0, 4}, {0, 0}},
                                    {{9, 9}, {10, 9}, {9, 10}, {9, 9}},
                                    {{5, 5}, {6, 5}, {5, 6}, {5, 5}}}));
}

TEST(ReadWkt, StrokesArcs) {
    // A circle of radius 5 about (5, 0): as an arc from end to end, it covers pi 25.
    const Shape disc = shape_of("CURVEPOLYGON (CIRCULARSTRING (0 0, 10 0, 0 0))");
    ASSERT_EQ(disc.parts.size(), 1U);
    const std::vector<Point2>& ring = disc.parts.front();
    EXPECT_EQ(ring.front(), ring.back());
    double area_m2 = 0.0;
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
        EXPECT_NEAR(std::hypot(ring[i].x_m - 5.0, ring[i].y_m), 5.0, 1e-12);
        area_m2 += 0.5 * (ring[i].x_m * ring[i + 1].y_m - ring[i + 1].x_m * ring[i].y_m);
    }
    // Chords that lie up to 1 cm beside the arc take at most the share 4/3 x 0.01 / 5 of the disc.
    EXPECT_NEAR(std::abs(area_m2), 25.0 * 3.14159265358979, 25.0 * 3.14159265358979 * 4.0 / 3.0 * 0.01 / 5.0);
}

TEST(WktHeights, FollowArcs) {
    const auto heights = read_wkt_heights(
        "COMPOUNDCURVE Z ((0 0 1, 1 0 2), CIRCULARSTRING Z (1 0 2, 2 1 4, 3 0 8))", {"a.csv"});
    ASSERT_EQ(heights.size(), 1U);
    EXPECT_EQ(heights[0].size(),
              shape_of("COMPOUNDCURVE ((0 0, 1 0), CIRCULARSTRING (1 0, 2 1, 3 0))").parts[0].size());
    EXPECT_EQ(heights[0].front(), 1.0);
    EXPECT_EQ(heights[0].back(), 8.0);
    EXPECT_TRUE(std::is_sorted(heights[0].begin(), heights[0].end()));
}

TEST(WktHeights, AreThoseOfAllPointsOfAPartOrNone) {
    const auto heights = read_wkt_heights("MULTILINESTRING Z ((0 0 5, 1 0 6 9), (2 2 7, 3 3))", {"a.csv"});
    ASSERT_EQ(heights.size(), 2U);
    EXPECT_EQ(heights[0], (std::vector<double>{5.0, 6.0}));
    EXPECT_TRUE(heights[1].empty());
    EXPECT_EQ(read_wkt_heights("POINT Z (1 2 3)", {"a.csv"}).at(0), std::vector<double>{3.0});
    EXPECT_TRUE(read_wkt_heights("POINT (1 2)", {"a.csv"}).at(0).empty());
}

}  // namespace
}  // namespace config::wkt_test
