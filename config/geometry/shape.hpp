#pragma once

#include <optional>
#include <span>
#include <vector>

#include "config/grid/raster.hpp"

namespace config {

/// A place on the map.
struct Point2 {
    double x_m = 0.0;
    double y_m = 0.0;
    friend bool operator==(const Point2&, const Point2&) = default;
};

/// Points, lines or polygons, each kind also several at once.
struct Shape {
    enum class Kind { point, line, polygon };

    Kind kind = Kind::point;
    /// Each point alone; each line; each ring of a polygon, closed (first point = last), outer rings and
    /// holes alike: what an odd number of rings goes round lies inside.
    std::vector<std::vector<Point2>> parts;

    friend bool operator==(const Shape&, const Shape&) = default;
};

/// Whether a point lies inside a polygon, even-odd over its rings. Of the border, the southern and western
/// sides of a rectangle belong to it, so polygons that share a border share no point.
bool point_in_polygon(const Shape& polygon, Point2 point);

/// Length of a line [m].
double length_m(std::span<const Point2> line);

/// Where a point lies with respect to a line.
struct LinePosition {
    double along_m = 0.0;   ///< from the start of the line to its point nearest by
    double offset_m = 0.0;  ///< distance from there, never negative
};

/// The nearest place of a line; the first one if there are several. Requires at least one point.
LinePosition position_along(std::span<const Point2> line, Point2 point);

/// The point at a distance from the start, no further than the ends. Requires at least one point.
Point2 point_along(std::span<const Point2> line, double along_m);

/// A polygon and the number that its cells get.
struct CodedPolygon {
    Shape polygon;
    double code = 0.0;
};

/// A cell belongs to a polygon if its centre lies in it; the later of two polygons wins. Elsewhere
/// `background`, which may be NaN. Requires shapes of kind polygon.
Raster<double> rasterise_polygons(const GridFrame& frame, std::span<const CodedPolygon> polygons,
                                  double background);

/// The cells of a frame that a line passes through, each once, in the order of the first passage. Cells
/// follow one another edge to edge, so nothing slips through diagonally.
std::vector<Cell> cells_along_line(const GridFrame& frame, std::span<const Point2> line);

}  // namespace config
