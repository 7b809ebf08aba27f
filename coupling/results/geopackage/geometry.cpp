#include "coupling/results/geopackage/geometry.hpp"

#include <algorithm>
#include <bit>

namespace coupling::geopackage {
namespace {

using config::Point2;
using Ring = std::vector<Point2>;

// Codes of ISO 13249-3; with height 1000 more, with measure 2000 more.
constexpr std::uint32_t point_code = 1;
constexpr std::uint32_t line_code = 2;
constexpr std::uint32_t polygon_code = 3;
constexpr std::uint32_t multi_line_code = 5;
constexpr std::uint32_t multi_polygon_code = 6;

std::uint32_t with(std::uint32_t code, Dimensions dimensions) {
    return code + (dimensions.z ? 1000U : 0U) + (dimensions.m ? 2000U : 0U);
}

class Blob {
public:
    Blob(const Extent& extent, std::int32_t srs_id) : extent_{extent} {
        bytes_ = {'G', 'P', 0, 0b0000'0011};  // version 1; least byte first, extent x and y, not empty
        add(static_cast<std::uint32_t>(srs_id));
        for (const double bound : {extent.low_x_m, extent.high_x_m, extent.low_y_m, extent.high_y_m}) {
            add(bound);
        }
    }

    void add(std::uint32_t value) { add_bytes(value); }
    void add(double value) { add_bytes(std::bit_cast<std::uint64_t>(value)); }
    void begin(std::uint32_t code) {
        bytes_.push_back(1);  // least byte first
        add(code);
    }
    void count(std::size_t value) { add(static_cast<std::uint32_t>(value)); }
    void corners(const Ring& ring) {
        count(ring.size());
        for (const Point2& corner : ring) {
            add(corner.x_m);
            add(corner.y_m);
        }
    }
    [[nodiscard]] Geometry done() { return {std::move(bytes_), extent_}; }

private:
    template <class Bits>
    void add_bytes(Bits value) {
        for (std::size_t i = 0; i < sizeof(Bits); ++i) {
            bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
        }
    }

    std::vector<std::uint8_t> bytes_;
    Extent extent_;
};

Extent extent_of(std::span<const Ring> rings) {
    Extent extent;
    for (const Ring& ring : rings) {
        for (const Point2& corner : ring) {
            extent.add(corner.x_m, corner.y_m);
        }
    }
    return extent;
}

void add_vertex(Blob& blob, const Vertex& vertex, Dimensions dimensions) {
    blob.add(vertex.x_m);
    blob.add(vertex.y_m);
    if (dimensions.z) {
        blob.add(vertex.z_m);
    }
    if (dimensions.m) {
        blob.add(vertex.measure);
    }
}

/// The middle of the first edge: it lies on no other ring, where rings share corners at most.
Point2 place_of(const Ring& ring) {
    return {0.5 * (ring[0].x_m + ring[1].x_m), 0.5 * (ring[0].y_m + ring[1].y_m)};
}

/// How many other rings go round a ring, and the innermost of these.
struct Nesting {
    std::size_t depth = 0;
    std::size_t inside = 0;
};

std::vector<Nesting> nesting_of(std::span<const Ring> rings) {
    const auto lies_in = [&](std::size_t ring, std::size_t other) {
        return ring != other && rings[ring].size() > 1 &&
               config::point_in_polygon({config::Shape::Kind::polygon, {rings[other]}},
                                        place_of(rings[ring]));
    };
    std::vector<Nesting> nesting(rings.size());
    for (std::size_t ring = 0; ring < rings.size(); ++ring) {
        for (std::size_t other = 0; other < rings.size(); ++other) {
            nesting[ring].depth += lies_in(ring, other) ? 1 : 0;
        }
    }
    for (std::size_t ring = 0; ring < rings.size(); ++ring) {
        for (std::size_t other = 0; other < rings.size(); ++other) {
            if (lies_in(ring, other) && nesting[other].depth + 1 == nesting[ring].depth) {
                nesting[ring].inside = other;
            }
        }
    }
    return nesting;
}

}  // namespace

void Extent::add(double x_m, double y_m) {
    low_x_m = empty ? x_m : std::min(low_x_m, x_m);
    high_x_m = empty ? x_m : std::max(high_x_m, x_m);
    low_y_m = empty ? y_m : std::min(low_y_m, y_m);
    high_y_m = empty ? y_m : std::max(high_y_m, y_m);
    empty = false;
}

void Extent::add(const Extent& other) {
    if (!other.empty) {
        add(other.low_x_m, other.low_y_m);
        add(other.high_x_m, other.high_y_m);
    }
}

Geometry point(const Vertex& vertex, Dimensions dimensions, std::int32_t srs_id) {
    Extent extent;
    extent.add(vertex.x_m, vertex.y_m);
    Blob blob{extent, srs_id};
    blob.begin(with(point_code, dimensions));
    add_vertex(blob, vertex, dimensions);
    return blob.done();
}

Geometry line(std::span<const Vertex> vertices, Dimensions dimensions, std::int32_t srs_id) {
    Extent extent;
    for (const Vertex& vertex : vertices) {
        extent.add(vertex.x_m, vertex.y_m);
    }
    Blob blob{extent, srs_id};
    blob.begin(with(line_code, dimensions));
    blob.count(vertices.size());
    for (const Vertex& vertex : vertices) {
        add_vertex(blob, vertex, dimensions);
    }
    return blob.done();
}

Geometry lines(std::span<const Ring> parts, std::int32_t srs_id) {
    Blob blob{extent_of(parts), srs_id};
    blob.begin(multi_line_code);
    blob.count(parts.size());
    for (const Ring& part : parts) {
        blob.begin(line_code);
        blob.corners(part);
    }
    return blob.done();
}

Geometry polygons(std::span<const Ring> rings, std::int32_t srs_id) {
    const std::vector<Nesting> nesting = nesting_of(rings);
    const auto is_outer = [](const Nesting& ring) { return ring.depth % 2 == 0; };
    Blob blob{extent_of(rings), srs_id};
    blob.begin(multi_polygon_code);
    blob.count(static_cast<std::size_t>(std::count_if(nesting.begin(), nesting.end(), is_outer)));
    for (std::size_t outer = 0; outer < rings.size(); ++outer) {
        if (!is_outer(nesting[outer])) {
            continue;
        }
        const auto is_hole = [&](const Nesting& ring) { return !is_outer(ring) && ring.inside == outer; };
        blob.begin(polygon_code);
        blob.count(1 + static_cast<std::size_t>(std::count_if(nesting.begin(), nesting.end(), is_hole)));
        blob.corners(rings[outer]);
        for (std::size_t ring = 0; ring < rings.size(); ++ring) {
            if (is_hole(nesting[ring])) {
                blob.corners(rings[ring]);
            }
        }
    }
    return blob.done();
}

Geometry rectangle(const Extent& extent, std::int32_t srs_id) {
    Blob blob{extent, srs_id};
    blob.begin(polygon_code);
    blob.count(1);
    blob.corners({{extent.low_x_m, extent.low_y_m},
                  {extent.high_x_m, extent.low_y_m},
                  {extent.high_x_m, extent.high_y_m},
                  {extent.low_x_m, extent.high_y_m},
                  {extent.low_x_m, extent.low_y_m}});
    return blob.done();
}

}  // namespace coupling::geopackage
