#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "coupling/results/geopackage/geometry.hpp"

namespace coupling::geopackage {

/// A geometry as corners again.
struct StoredGeometry {
    enum class Kind : std::uint8_t { point, line, area };
    /// A line, or a closed ring. Holes follow the outer ring around them.
    struct Part {
        std::vector<Vertex> corners;
        bool is_hole = false;
    };
    Kind kind = Kind::point;
    Dimensions dimensions;
    std::vector<Part> parts;
};

/// Reads what `geometry` writes. Throws std::invalid_argument for other bytes.
StoredGeometry read_geometry(std::span<const std::uint8_t> bytes);

}  // namespace coupling::geopackage
