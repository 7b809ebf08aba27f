#include "forest/treatment/area.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "forest/light/direction.hpp"

namespace forest {

namespace {

constexpr int points_a_side = 5;

/// The upright rectangle around a polygon.
struct Box {
    config::Point2 low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    config::Point2 high{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};

    explicit Box(const config::Shape& polygon) {
        for (const auto& ring : polygon.parts) {
            for (const config::Point2 point : ring) {
                low = {std::min(low.x_m, point.x_m), std::min(low.y_m, point.y_m)};
                high = {std::max(high.x_m, point.x_m), std::max(high.y_m, point.y_m)};
            }
        }
    }
    /// Whether a square around a point meets it.
    [[nodiscard]] bool meets(config::Point2 point, double half_side_m) const {
        return point.x_m >= low.x_m - half_side_m && point.x_m <= high.x_m + half_side_m &&
               point.y_m >= low.y_m - half_side_m && point.y_m <= high.y_m + half_side_m;
    }
};

/// Polygons with their boxes: most points are far from most polygons.
class Outline {
public:
    explicit Outline(const TreatmentArea& area)
        : polygons_{area.polygons}, boxes_(area.polygons.begin(), area.polygons.end()) {}

    [[nodiscard]] bool holds(config::Point2 point) const {
        for (std::size_t i = 0; i < boxes_.size(); ++i) {
            if (boxes_[i].meets(point, 0.0) && config::point_in_polygon(polygons_[i], point)) {
                return true;
            }
        }
        return polygons_.empty();
    }
    /// Whether a square around a point may hold points of it.
    [[nodiscard]] bool may_meet(config::Point2 point, double half_side_m) const {
        return polygons_.empty() || std::any_of(boxes_.begin(), boxes_.end(), [&](const Box& box) {
                   return box.meets(point, half_side_m);
               });
    }

private:
    std::span<const config::Shape> polygons_;
    std::vector<Box> boxes_;
};

bool in_units(const TreatmentArea& area, const Patch& patch) {
    const auto& units = area.management_units;
    const double slope_deg = patch.slope.in_degrees();
    if (slope_deg < area.from_slope_deg || slope_deg > area.to_slope_deg) {
        return false;
    }
    return units.empty() || std::find(units.begin(), units.end(), patch.management_unit) != units.end();
}

/// A place in axes along a direction and to its left.
struct Turned {
    double along_m = 0.0;
    double left_m = 0.0;
};

Turned turned(config::Point2 point, const Turn& direction) {
    return {point.x_m * direction.cos + point.y_m * direction.sin,
            point.y_m * direction.cos - point.x_m * direction.sin};
}

config::Point2 on_map(const Turned& place, const Turn& direction) {
    return {place.along_m * direction.cos - place.left_m * direction.sin,
            place.along_m * direction.sin + place.left_m * direction.cos};
}

/// What the middles of all patches span in turned axes, half a patch more on every side.
struct Span {
    Turned low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    Turned high{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};
};

Span span_of(const PatchGrid& grid, const Turn& direction) {
    Span span;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const PatchId id{static_cast<std::uint32_t>(i)};
        const Turned place = turned({grid.x_centre_m(id), grid.y_centre_m(id)}, direction);
        span.low.along_m = std::min(span.low.along_m, place.along_m - patch_side_m);
        span.low.left_m = std::min(span.low.left_m, place.left_m - patch_side_m);
        span.high.along_m = std::max(span.high.along_m, place.along_m + patch_side_m);
        span.high.left_m = std::max(span.high.left_m, place.left_m + patch_side_m);
    }
    return span;
}

}  // namespace

bool belongs(const TreatmentArea& area, const PatchGrid& grid, double x_m, double y_m) {
    const std::optional<PatchId> patch = grid.at(x_m, y_m);
    return patch && in_units(area, grid[*patch]) && Outline{area}.holds({x_m, y_m});
}

std::vector<std::size_t> trees_in(const Stand& stand, const TreatmentArea& area) {
    const Outline outline{area};
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < stand.trees().size(); ++i) {
        const Tree& tree = stand.trees()[i];
        if (in_units(area, stand.grid()[tree.patch]) && outline.holds({tree.x_m, tree.y_m})) {
            places.push_back(i);
        }
    }
    return places;
}

std::vector<PatchId> patches_in(const PatchGrid& grid, const TreatmentArea& area) {
    const Outline outline{area};
    std::vector<PatchId> patches;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const PatchId id{static_cast<std::uint32_t>(i)};
        if (in_units(area, grid[id]) && outline.holds({grid.x_centre_m(id), grid.y_centre_m(id)})) {
            patches.push_back(id);
        }
    }
    return patches;
}

double area_ha(const PatchGrid& grid, const TreatmentArea& area) {
    constexpr double m2_per_ha = 10'000.0;
    constexpr double point_side_m = patch_side_m / points_a_side;
    const Outline outline{area};
    std::size_t points = 0;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const PatchId id{static_cast<std::uint32_t>(i)};
        if (!in_units(area, grid[id]) ||
            !outline.may_meet({grid.x_centre_m(id), grid.y_centre_m(id)}, 0.5 * patch_side_m)) {
            continue;
        }
        for (int row = 0; row < points_a_side; ++row) {
            for (int column = 0; column < points_a_side; ++column) {
                const double middle = 0.5 * (points_a_side - 1);
                points += outline.holds({grid.x_centre_m(id) + (column - middle) * point_side_m,
                                         grid.y_centre_m(id) + (row - middle) * point_side_m})
                              ? 1
                              : 0;
            }
        }
    }
    return static_cast<double>(points) * point_side_m * point_side_m / m2_per_ha;
}

config::Shape rectangle(config::Point2 centre, double length_m, double width_m, config::Angle direction) {
    const Turn turn = turn_of(direction);
    const auto corner = [&](double along, double left) {
        const config::Point2 offset = on_map({along * 0.5 * length_m, left * 0.5 * width_m}, turn);
        return config::Point2{centre.x_m + offset.x_m, centre.y_m + offset.y_m};
    };
    return {config::Shape::Kind::polygon,
            {{corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1), corner(-1, -1)}}};
}

std::vector<config::Shape> corridor(std::span<const config::Point2> line, double width_m) {
    assert(line.size() >= 2 && width_m > 0.0);
    std::vector<config::Shape> pieces;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const config::Point2 from = line[i];
        const config::Point2 to = line[i + 1];
        const double dx = to.x_m - from.x_m;
        const double dy = to.y_m - from.y_m;
        const double length_m = std::sqrt(dx * dx + dy * dy);
        if (length_m <= 0.0) {
            continue;  // a point of the line twice
        }
        const double left_x_m = -dy / length_m * 0.5 * width_m;
        const double left_y_m = dx / length_m * 0.5 * width_m;
        pieces.push_back({config::Shape::Kind::polygon,
                          {{{from.x_m - left_x_m, from.y_m - left_y_m},
                            {to.x_m - left_x_m, to.y_m - left_y_m},
                            {to.x_m + left_x_m, to.y_m + left_y_m},
                            {from.x_m + left_x_m, from.y_m + left_y_m},
                            {from.x_m - left_x_m, from.y_m - left_y_m}}}});
        if (i > 0) {
            constexpr int corners = 16;
            config::Shape joint{config::Shape::Kind::polygon, {{}}};
            for (int k = 0; k <= corners; ++k) {
                const Turn turn = turn_of(config::Angle::from_degrees(360.0 / corners * (k % corners)));
                joint.parts.front().push_back(
                    {from.x_m + 0.5 * width_m * turn.cos, from.y_m + 0.5 * width_m * turn.sin});
            }
            pieces.push_back(std::move(joint));
        }
    }
    return pieces;
}

double open_length_m(const Slit& slit) {
    const Turn turn = turn_of(slit.to_fall_line);
    const double across_width_m =
        turn.sin != 0.0 ? slit.width_m / std::abs(turn.sin) : std::numeric_limits<double>::max();
    const double across_length_m =
        turn.cos != 0.0 ? slit.length_m / std::abs(turn.cos) : std::numeric_limits<double>::max();
    return std::min(across_width_m, across_length_m);
}

config::Angle fall_line_of(const Patch& patch) {
    return config::Angle::from_degrees(90.0 - patch.aspect.in_degrees());
}

config::Angle mean_fall_line(const PatchGrid& grid) {
    double x = 0.0;
    double y = 0.0;
    for (const Patch& patch : grid.patches()) {
        const Turn aspect = turn_of(patch.aspect);
        const double steepness = turn_of(patch.slope).sin;
        x += steepness * aspect.sin;
        y += steepness * aspect.cos;
    }
    return config::Angle::from_degrees(90.0 - azimuth_of(x, y).in_degrees());
}

config::Shape slit_at(config::Point2 centre, config::Angle fall_line, const Slit& slit) {
    return rectangle(centre, slit.length_m, slit.width_m,
                     config::Angle::from_degrees(fall_line.in_degrees() + slit.to_fall_line.in_degrees()));
}

std::vector<config::Shape> ladder_of_slits(const PatchGrid& grid, const Slit& slit, double gap_m,
                                           double lines_m, int entry, int entries) {
    assert(entry >= 0 && entry < entries && lines_m > 0.0);
    const config::Angle fall_line = mean_fall_line(grid);
    const Turn down = turn_of(fall_line);
    const Turn axis = turn_of(slit.to_fall_line);
    const Span span = span_of(grid, down);
    const double extent_m = slit.length_m * std::abs(axis.cos) + slit.width_m * std::abs(axis.sin);
    const double rung_m = extent_m + gap_m;
    assert(rung_m > 0.0);
    constexpr double half = 0.5;
    const double whole_ha = slit.length_m * slit.width_m / 10'000.0;

    std::vector<config::Shape> slits;
    int line = 0;
    for (double left_m = span.low.left_m + half * lines_m; left_m < span.high.left_m;
         left_m += lines_m, ++line) {
        int rung = line % 2 * (entries / 2);
        for (double along_m = span.low.along_m + half * rung_m; along_m < span.high.along_m;
             along_m += rung_m, ++rung) {
            if (rung % entries != entry) {
                continue;
            }
            const config::Shape shape = slit_at(on_map({along_m, left_m}, down), fall_line, slit);
            if (area_ha(grid, {{shape}, {}}) >= half * whole_ha) {
                slits.push_back(shape);
            }
        }
    }
    return slits;
}

std::vector<config::Shape> strips(const PatchGrid& grid, double width_m, config::Angle direction, int entry,
                                  int entries) {
    assert(entry >= 0 && entry < entries && width_m > 0.0);
    const Turn turn = turn_of(direction);
    const Span span = span_of(grid, turn);
    const double middle_m = 0.5 * (span.low.along_m + span.high.along_m);
    std::vector<config::Shape> shapes;
    int strip = 0;
    for (double left_m = span.low.left_m; left_m < span.high.left_m; left_m += width_m, ++strip) {
        if (strip % entries == entry) {
            shapes.push_back(rectangle(on_map({middle_m, left_m + 0.5 * width_m}, turn),
                                       span.high.along_m - span.low.along_m, width_m, direction));
        }
    }
    return shapes;
}

}  // namespace forest
