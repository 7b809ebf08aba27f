#pragma once

#include <span>
#include <string>

#include "config/geometry/shape.hpp"
#include "config/grid/raster.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling::plausible {

/// A rectangle in the coordinates of the input.
struct Extent {
    double west_m = 0.0;
    double east_m = 0.0;
    double south_m = 0.0;
    double north_m = 0.0;

    [[nodiscard]] bool contains(const config::Point2& point) const {
        return point.x_m >= west_m && point.x_m <= east_m && point.y_m >= south_m && point.y_m <= north_m;
    }
    [[nodiscard]] bool covers(const Extent& other) const {
        return contains({other.west_m, other.south_m}) && contains({other.east_m, other.north_m});
    }
    [[nodiscard]] bool overlaps(const Extent& other) const {
        return other.west_m <= east_m && other.east_m >= west_m && other.south_m <= north_m &&
               other.north_m >= south_m;
    }
};

/// Requires at least one point.
Extent extent_of(std::span<const config::Point2> points);
Extent extent_of(const config::GridFrame& frame);
/// In absolute coordinates.
Extent extent_of(const rockfall::Terrain& terrain);

/// "177 198 to 178 298 east, 376 898 to 378 102 north"; with decimals where the numbers are small.
std::string in_words(const Extent& extent);

}  // namespace coupling::plausible
