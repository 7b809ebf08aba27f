#include "config/geometry/shape.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numbers>

namespace config::shape_test {
namespace {

const GridFrame frame{.columns = 12,
                      .rows = 9,
                      .x_west_m = 100.0,
                      .y_south_m = 200.0,
                      .cell_width_m = 5.0,
                      .cell_height_m = 4.0};

/// A square of 4 m with a hole of 2 m.
const Shape square_with_hole{
    Shape::Kind::polygon,
    {{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}, {{1, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 1}}}};

/// Three sides of 30 m, 40 m and 30 m.
const std::vector<Point2> bent_line{{0, 0}, {30, 0}, {30, 40}, {60, 40}};

rc::Gen<Point2> point_near_the_frame() {
    return rc::gen::map(rc::gen::pair(rc::gen::inRange(-40, 201), rc::gen::inRange(-40, 201)),
                        [](const auto& v) {
                            return Point2{90.0 + 0.5 * v.first, 190.0 + 0.5 * v.second};
                        });
}

Point2 centre_of(Cell cell) {
    return {frame.x_centre_m(cell.column), frame.y_centre_m(cell.row)};
}

TEST(PointInPolygon, LeavesHolesOut) {
    EXPECT_TRUE(point_in_polygon(square_with_hole, {0.5, 2.0}));
    EXPECT_FALSE(point_in_polygon(square_with_hole, {2.0, 2.0}));
    EXPECT_FALSE(point_in_polygon(square_with_hole, {5.0, 2.0}));
    EXPECT_FALSE(point_in_polygon(square_with_hole, {2.0, -1.0}));
}

TEST(PointInPolygon, CountsTheSouthernAndWesternBorderOnly) {
    EXPECT_TRUE(point_in_polygon(square_with_hole, {0.0, 0.0}));
    EXPECT_TRUE(point_in_polygon(square_with_hole, {0.0, 2.0}));
    EXPECT_TRUE(point_in_polygon(square_with_hole, {2.0, 0.0}));
    EXPECT_FALSE(point_in_polygon(square_with_hole, {4.0, 2.0}));
    EXPECT_FALSE(point_in_polygon(square_with_hole, {2.0, 4.0}));
}

RC_GTEST_PROP(PointInPolygon, GivesEveryPointToOneOfTwoNeighbours, ()) {
    const Point2 a = *point_near_the_frame();
    const Point2 b = *point_near_the_frame();
    const Point2 left = *point_near_the_frame();
    const Point2 right = *point_near_the_frame();
    const Shape first{Shape::Kind::polygon, {{a, b, left, a}}};
    const Shape second{Shape::Kind::polygon, {{b, a, right, b}}};
    const Shape both{Shape::Kind::polygon, {{a, left, b, right, a}}};
    const Point2 point = *point_near_the_frame();
    RC_ASSERT((point_in_polygon(first, point) != point_in_polygon(second, point)) ==
              point_in_polygon(both, point));
}

RC_GTEST_PROP(RasterisePolygons, GivesACellToThePolygonAroundItsCentre, ()) {
    std::vector<CodedPolygon> polygons;
    for (int code = 1; code <= 2; ++code) {
        std::vector<Point2> ring;
        const int corners = *rc::gen::inRange(3, 8);
        for (int corner = 0; corner < corners; ++corner) {
            ring.push_back(*point_near_the_frame());
        }
        ring.push_back(ring.front());
        polygons.push_back({{Shape::Kind::polygon, {ring}}, static_cast<double>(code)});
    }
    const Raster<double> raster = rasterise_polygons(frame, polygons, 0.0);
    for (std::size_t index = 0; index < frame.size(); ++index) {
        const Point2 centre = centre_of(frame.cell_of(index));
        const double code = point_in_polygon(polygons[1].polygon, centre)   ? 2.0
                            : point_in_polygon(polygons[0].polygon, centre) ? 1.0
                                                                            : 0.0;
        RC_ASSERT(raster.values[index] == code);
    }
}

TEST(RasterisePolygons, KeepsTheBackgroundWhereNoneLies) {
    const std::vector<CodedPolygon> far_away{{square_with_hole, 3.0}};
    const Raster<double> raster = rasterise_polygons(frame, far_away, -1.0);
    EXPECT_TRUE(std::all_of(raster.values.begin(), raster.values.end(), [](double v) { return v == -1.0; }));
}

TEST(Length, AddsUpThePieces) {
    EXPECT_DOUBLE_EQ(length_m(bent_line), 100.0);
    EXPECT_EQ(length_m({}), 0.0);
}

TEST(PositionAlong, FindsTheNearestPlace) {
    const LinePosition position = position_along(bent_line, {33.0, 20.0});
    EXPECT_DOUBLE_EQ(position.along_m, 50.0);
    EXPECT_DOUBLE_EQ(position.offset_m, 3.0);
    EXPECT_DOUBLE_EQ(position_along(bent_line, {-3.0, 4.0}).offset_m, 5.0);
    EXPECT_EQ(position_along(bent_line, {-3.0, 4.0}).along_m, 0.0);
    EXPECT_DOUBLE_EQ(position_along(bent_line, {70.0, 40.0}).along_m, 100.0);
}

TEST(PointAlong, IsUndoneByPositionAlong) {
    for (double along_m = 0.0; along_m <= 100.0; along_m += 2.5) {
        const LinePosition position = position_along(bent_line, point_along(bent_line, along_m));
        EXPECT_NEAR(position.along_m, along_m, 1e-12);
        EXPECT_NEAR(position.offset_m, 0.0, 1e-12);
    }
    EXPECT_EQ(point_along(bent_line, -1.0), bent_line.front());
    EXPECT_EQ(point_along(bent_line, 101.0), bent_line.back());
}

TEST(CellsAlongLine, FollowsStraightLines) {
    const std::vector<Point2> eastward{{102.0, 230.0}, {117.0, 230.0}};
    EXPECT_EQ(cells_along_line(frame, eastward), (std::vector<Cell>{{0, 1}, {1, 1}, {2, 1}, {3, 1}}));
    const std::vector<Point2> southward{{102.0, 234.0}, {102.0, 226.0}};
    EXPECT_EQ(cells_along_line(frame, southward), (std::vector<Cell>{{0, 0}, {0, 1}, {0, 2}}));
    const std::vector<Point2> standing{{102.0, 234.0}, {102.0, 234.0}};
    EXPECT_EQ(cells_along_line(frame, standing), (std::vector<Cell>{{0, 0}}));
}

TEST(CellsAlongLine, NamesEachCellOnceWhereALineComesBack) {
    const std::vector<Point2> there_and_back{{102.0, 230.0}, {117.0, 230.0}, {102.0, 230.0}};
    EXPECT_EQ(cells_along_line(frame, there_and_back).size(), 4U);
}

TEST(CellsAlongLine, TakesOnlyCellsOfTheFrame) {
    const std::vector<Point2> beside{{0.0, 0.0}, {50.0, 50.0}};
    EXPECT_TRUE(cells_along_line(frame, beside).empty());
    const std::vector<Point2> right_through{{-1e9, 230.0}, {1e9, 230.0}};
    EXPECT_EQ(cells_along_line(frame, right_through).size(), 12U);
    const std::vector<Point2> north_of_it{{-1e9, 300.0}, {1e9, 300.0}};
    EXPECT_TRUE(cells_along_line(frame, north_of_it).empty());
}

RC_GTEST_PROP(CellsAlongLine, HoldsEveryPointOfTheLine, ()) {
    const std::vector<Point2> line{*point_near_the_frame(), *point_near_the_frame()};
    const std::vector<Cell> cells = cells_along_line(frame, line);
    // Shares that miss the corners of cells: there rounding decides which cell a point falls into.
    for (int i = 0; i < 200; ++i) {
        const double share = (i + 1.0 / std::numbers::e) / 200.0;
        const Point2 point = point_along(line, share * length_m(line));
        const Cell cell = frame.cell_at(point.x_m, point.y_m);
        const bool on_an_edge =
            std::abs(std::remainder(point.x_m - frame.x_west_m, frame.cell_width_m)) < 1e-9 ||
            std::abs(std::remainder(point.y_m - frame.y_south_m, frame.cell_height_m)) < 1e-9;
        RC_ASSERT(on_an_edge || !frame.contains(cell) ||
                  std::find(cells.begin(), cells.end(), cell) != cells.end());
    }
}

RC_GTEST_PROP(CellsAlongLine, GoesFromEdgeToEdge, ()) {
    const auto inside =
        rc::gen::map(rc::gen::pair(rc::gen::inRange(0, 120), rc::gen::inRange(1, 73)), [](const auto& v) {
            return Point2{100.0 + 0.5 * v.first, 200.0 + 0.5 * v.second};
        });
    const std::vector<Cell> cells = cells_along_line(frame, std::vector<Point2>{*inside, *inside});
    for (std::size_t i = 1; i < cells.size(); ++i) {
        RC_ASSERT(
            std::abs(cells[i].column - cells[i - 1].column) + std::abs(cells[i].row - cells[i - 1].row) == 1);
    }
}

RC_GTEST_PROP(CellsAlongLine, TakesNoCellThatTheLineDoesNotTouch, ()) {
    const std::vector<Point2> line{*point_near_the_frame(), *point_near_the_frame()};
    for (const Cell cell : cells_along_line(frame, line)) {
        const double half_diagonal_m = std::hypot(0.5 * frame.cell_width_m, 0.5 * frame.cell_height_m);
        RC_ASSERT(position_along(line, centre_of(cell)).offset_m <= half_diagonal_m + 1e-9);
    }
}

}  // namespace
}  // namespace config::shape_test
