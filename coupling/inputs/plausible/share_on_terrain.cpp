#include "coupling/inputs/plausible/share_on_terrain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace coupling::plausible {
namespace {

using config::Point2;
using config::Shape;

/// Sums what lies on the terrain and what there is.
class ShareSum {
public:
    explicit ShareSum(const rockfall::Terrain& terrain) : terrain_{terrain} {}

    void add(const Point2& point, double weight) {
        const Eigen::Vector2d origin_m = terrain_.origin_m();
        const double x_m = point.x_m - origin_m.x();
        const double y_m = point.y_m - origin_m.y();
        const auto triangle = near_ ? terrain_.locate(x_m, y_m, *near_) : terrain_.locate(x_m, y_m);
        near_ = triangle ? triangle : near_;
        all_ += weight;
        on_ += triangle ? weight : 0.0;
    }
    [[nodiscard]] bool is_off() const { return on_ == 0.0; }
    [[nodiscard]] OnTerrain result() const { return {all_, all_ > 0.0 ? on_ / all_ : 1.0}; }

private:
    const rockfall::Terrain& terrain_;
    std::optional<std::uint32_t> near_;  ///< triangle of the last point on the terrain
    double all_ = 0.0;
    double on_ = 0.0;
};

std::vector<Point2> vertices_of(const Shape& shape) {
    std::vector<Point2> vertices;
    for (const auto& part : shape.parts) {
        vertices.insert(vertices.end(), part.begin(), part.end());
    }
    return vertices;
}

OnTerrain by_vertices(const Shape& shape, const rockfall::Terrain& terrain) {
    ShareSum sum{terrain};
    for (const Point2& vertex : vertices_of(shape)) {
        sum.add(vertex, 1.0);
    }
    return sum.result();
}

OnTerrain by_area(const Shape& polygon, const rockfall::Terrain& terrain, int places) {
    const Extent box = extent_of(vertices_of(polygon));
    const config::GridFrame frame{.columns = places,
                                  .rows = places,
                                  .x_west_m = box.west_m,
                                  .y_south_m = box.south_m,
                                  .cell_width_m = (box.east_m - box.west_m) / places,
                                  .cell_height_m = (box.north_m - box.south_m) / places};
    ShareSum sum{terrain};
    if (!(frame.cell_width_m > 0.0 && frame.cell_height_m > 0.0)) {
        return sum.result();
    }
    const std::array<config::CodedPolygon, 1> only{config::CodedPolygon{polygon, 1.0}};
    const config::Raster<double> inside = config::rasterise_polygons(frame, only, 0.0);
    for (std::size_t i = 0; i < inside.values.size(); ++i) {
        if (inside.values[i] > 0.0) {
            const config::Cell cell = frame.cell_of(i);
            sum.add({frame.x_centre_m(cell.column), frame.y_centre_m(cell.row)},
                    frame.cell_width_m * frame.cell_height_m);
        }
    }
    return sum.result();
}

OnTerrain by_length(const Shape& lines, const rockfall::Terrain& terrain) {
    constexpr double pieces = 1000.0;
    double all_m = 0.0;
    for (const auto& part : lines.parts) {
        all_m += config::length_m(part);
    }
    ShareSum sum{terrain};
    for (const auto& part : lines.parts) {
        for (std::size_t i = 1; i < part.size(); ++i) {
            const Point2& from = part[i - 1];
            const Point2& to = part[i];
            const double length_m = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
            const int steps = all_m > 0.0 ? std::max(1, static_cast<int>(pieces * length_m / all_m)) : 0;
            for (int k = 0; k < steps; ++k) {
                const double share = (k + 0.5) / steps;
                sum.add({from.x_m + share * (to.x_m - from.x_m), from.y_m + share * (to.y_m - from.y_m)},
                        length_m / steps);
            }
        }
    }
    return sum.result();
}

/// The part of a straight way inside an extent, as shares of the way; nothing where it misses the extent.
std::optional<std::pair<double, double>> part_inside(const Point2& from, const Point2& to,
                                                     const Extent& extent) {
    double first = 0.0;
    double last = 1.0;
    const auto cut = [&](double start, double way, double low, double high) {
        if (way == 0.0) {
            return start >= low && start <= high;
        }
        const auto [near, far] = std::minmax({(low - start) / way, (high - start) / way});
        first = std::max(first, near);
        last = std::min(last, far);
        return first <= last;
    };
    const bool meets = cut(from.x_m, to.x_m - from.x_m, extent.west_m, extent.east_m) &&
                       cut(from.y_m, to.y_m - from.y_m, extent.south_m, extent.north_m);
    return meets ? std::optional{std::pair{first, last}} : std::nullopt;
}

bool way_touches(const Point2& from, const Point2& to, const rockfall::Terrain& terrain,
                 const Extent& extent) {
    const auto part = part_inside(from, to, extent);
    if (!part) {
        return false;
    }
    constexpr double steps_of_diagonal = 1000.0;
    const double step_m =
        std::hypot(extent.east_m - extent.west_m, extent.north_m - extent.south_m) / steps_of_diagonal;
    const double length_m = (part->second - part->first) * std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
    const double steps = std::max(1.0, std::ceil(length_m / step_m));
    ShareSum sum{terrain};
    for (double k = 0.0; k <= steps && sum.is_off(); ++k) {
        const double share = part->first + k / steps * (part->second - part->first);
        sum.add({from.x_m + share * (to.x_m - from.x_m), from.y_m + share * (to.y_m - from.y_m)}, 1.0);
    }
    return !sum.is_off();
}

/// Whether terrain lies inside a polygon that it does not cross.
bool holds_terrain(const Shape& polygon, const rockfall::Terrain& terrain) {
    constexpr std::size_t most_places = 1000;
    const auto& vertices = terrain.vertices();
    const std::size_t step = std::max<std::size_t>(1, vertices.size() / most_places);
    for (std::size_t i = 0; i < vertices.size(); i += step) {
        if (config::point_in_polygon(polygon,
                                     {static_cast<double>(vertices[i].x_m) + terrain.origin_m().x(),
                                      static_cast<double>(vertices[i].y_m) + terrain.origin_m().y()})) {
            return true;
        }
    }
    return false;
}

}  // namespace

bool touches_terrain(const Shape& shape, const rockfall::Terrain& terrain, const Extent& extent) {
    if (!extent.overlaps(extent_of(vertices_of(shape)))) {
        return false;
    }
    if (by_vertices(shape, terrain).share > 0.0) {
        return true;
    }
    for (const auto& part : shape.parts) {
        for (std::size_t i = 1; i < part.size() && shape.kind != Shape::Kind::point; ++i) {
            if (way_touches(part[i - 1], part[i], terrain, extent)) {
                return true;
            }
        }
    }
    return shape.kind == Shape::Kind::polygon && holds_terrain(shape, terrain);
}

int samples_a_side(std::size_t shapes) {
    return shapes > 100 ? 40 : 150;
}

OnTerrain on_terrain(const Shape& shape, const rockfall::Terrain& terrain, int samples) {
    if (shape.kind == Shape::Kind::point) {
        return by_vertices(shape, terrain);
    }
    const OnTerrain result =
        shape.kind == Shape::Kind::polygon ? by_area(shape, terrain, samples) : by_length(shape, terrain);
    return result.size > 0.0 ? result : by_vertices(shape, terrain);
}

std::string percent_in_words(double share) {
    const long percent = std::lround(100.0 * share);
    if (percent == 0 && share > 0.0) {
        return "less than 1 %";
    }
    if (percent == 100 && share < 1.0) {
        return "more than 99 %";
    }
    return std::to_string(percent) + " %";
}

}  // namespace coupling::plausible
