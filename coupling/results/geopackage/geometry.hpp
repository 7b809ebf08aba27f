#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "config/geometry/shape.hpp"

namespace coupling::geopackage {

/// A corner of a geometry. Height and measure count where the layer has them.
struct Vertex {
    double x_m = 0.0;
    double y_m = 0.0;
    double z_m = 0.0;
    double measure = 0.0;
};

/// Which numbers a corner has beside its place on the map.
struct Dimensions {
    bool z = false;
    bool m = false;
};

/// Smallest rectangle on the map; empty before anything was added.
struct Extent {
    double low_x_m = 0.0, high_x_m = 0.0, low_y_m = 0.0, high_y_m = 0.0;
    bool empty = true;

    void add(double x_m, double y_m);
    void add(const Extent& other);
};

/// A geometry as a GeoPackage stores it (OGC 12-128r17, 2.1.3): header with spatial reference and extent,
/// then well-known binary as in ISO 13249-3, all least byte first.
struct Geometry {
    std::vector<std::uint8_t> bytes;
    Extent extent;
};

Geometry point(const Vertex& vertex, Dimensions dimensions, std::int32_t srs_id);
/// Requires two corners.
Geometry line(std::span<const Vertex> vertices, Dimensions dimensions, std::int32_t srs_id);
/// Every line as a part of one geometry. Requires one line of two corners.
Geometry lines(std::span<const std::vector<config::Point2>> parts, std::int32_t srs_id);
/// Closed rings by the even-odd rule as polygons with their holes: a ring inside an odd number of others is a
/// hole of the innermost of them. Requires a ring.
Geometry polygons(std::span<const std::vector<config::Point2>> rings, std::int32_t srs_id);
/// A rectangle.
Geometry rectangle(const Extent& extent, std::int32_t srs_id);

}  // namespace coupling::geopackage
