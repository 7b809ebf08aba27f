#include "coupling/inputs/systems/extent.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling::plausible {
namespace {

using config::joined;

/// "177 198", "-5 000 000", "47.2634".
std::string grouped_coordinate(double value, bool with_decimals) {
    const double scale = with_decimals ? 1e4 : 1.0;
    const double rounded = std::round(scale * value) / scale;
    if (with_decimals || !(std::abs(rounded) < 1e15)) {
        return config::to_text(rounded);
    }
    std::string digits = std::to_string(static_cast<long long>(std::abs(rounded)));
    for (std::size_t at = digits.size(); at > 3;) {
        at -= 3;
        digits.insert(at, " ");
    }
    return rounded < 0.0 ? joined("-", digits) : digits;
}

}  // namespace

Extent extent_of(std::span<const config::Point2> points) {
    Extent extent{points.front().x_m, points.front().x_m, points.front().y_m, points.front().y_m};
    for (const config::Point2& point : points) {
        extent.west_m = std::min(extent.west_m, point.x_m);
        extent.east_m = std::max(extent.east_m, point.x_m);
        extent.south_m = std::min(extent.south_m, point.y_m);
        extent.north_m = std::max(extent.north_m, point.y_m);
    }
    return extent;
}

Extent extent_of(const config::GridFrame& frame) {
    return {frame.x_west_m, frame.x_east_m(), frame.y_south_m, frame.y_north_m()};
}

Extent extent_of(const rockfall::Terrain& terrain) {
    const Eigen::Vector2d origin_m = terrain.origin_m();
    std::vector<config::Point2> corners;
    corners.reserve(terrain.vertices().size());
    for (const rockfall::Vertex& vertex : terrain.vertices()) {
        corners.push_back(
            {origin_m.x() + static_cast<double>(vertex.x_m), origin_m.y() + static_cast<double>(vertex.y_m)});
    }
    return extent_of(corners);
}

std::string in_words(const Extent& extent) {
    const double largest = std::max({std::abs(extent.west_m), std::abs(extent.east_m),
                                     std::abs(extent.south_m), std::abs(extent.north_m)});
    const bool with_decimals = largest < 1000.0;
    const auto text = [&](double value) { return grouped_coordinate(value, with_decimals); };
    return joined(text(extent.west_m), " to ", text(extent.east_m), " east, ", text(extent.south_m), " to ",
                  text(extent.north_m), " north");
}

}  // namespace coupling::plausible
