#include "coupling/exchange/regimes/areas.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "config/table/shape_field.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling {
namespace {

using config::joined;

std::set<std::uint32_t> stands_of(const forest::PatchGrid& grid) {
    std::set<std::uint32_t> numbers;
    for (const forest::Patch& patch : grid.patches()) {
        numbers.insert(patch.management_unit);
    }
    return numbers;
}

config::Angle direction_of(const Ground& ground, const forest::PatchGrid& grid) {
    return config::Angle::from_degrees(forest::mean_fall_line(grid).in_degrees() + ground.angle_deg);
}

/// Slits of neighbouring rungs or ladders must not lie on each other.
bool slits_have_room(const Ground& ground, const config::Place& place, config::Problems& problems) {
    const double angle_rad = std::abs(ground.angle_deg) * std::numbers::pi / 180.0;
    const double extent_m = ground.length_m * std::cos(angle_rad) + ground.width_m * std::sin(angle_rad);
    const double rung_m = extent_m + ground.gap_m;
    const double least_m = std::min(extent_m, ground.width_m / std::max(std::sin(angle_rad), 1e-9));
    constexpr double rounding = 1e-3;
    if (rung_m < least_m * (1.0 - rounding)) {
        problems.add(
            config::ExitCode::data, place,
            joined("gap_m = ", config::to_text(ground.gap_m), ": slits of a ladder lie on each other"),
            joined("at least ", config::to_text(std::ceil(10.0 * (least_m - extent_m)) / 10.0)));
        return false;
    }
    if (ground.lines_m * rung_m < ground.length_m * ground.width_m * (1.0 - rounding)) {
        problems.add(
            config::ExitCode::data, place,
            joined("lines_m = ", config::to_text(ground.lines_m), ": more slits than there is ground"),
            joined("at least ",
                   config::to_text(std::ceil(10.0 * ground.length_m * ground.width_m / rung_m) / 10.0)));
        return false;
    }
    return true;
}

std::vector<Area> shaped(const std::vector<config::Shape>& shapes, const Ground& ground) {
    std::vector<Area> areas;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        areas.push_back({.number = static_cast<std::uint32_t>(i),
                         .order = static_cast<int>(i),
                         .place = {{shapes[i]}, ground.stands}});
    }
    return areas;
}

/// A line in several parts is one corridor.
std::vector<Area> corridors(const std::vector<config::Shape>& lines, const Ground& ground) {
    std::vector<Area> areas;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::vector<config::Shape> pieces;
        for (const auto& part : lines[i].parts) {
            for (config::Shape& piece : forest::corridor(part, ground.width_m)) {
                pieces.push_back(std::move(piece));
            }
        }
        areas.push_back({.number = static_cast<std::uint32_t>(i),
                         .order = static_cast<int>(i),
                         .place = {std::move(pieces), ground.stands}});
    }
    return areas;
}

std::vector<Area> slits(const Ground& ground, const forest::PatchGrid& grid) {
    const forest::Slit slit{ground.length_m, ground.width_m, config::Angle::from_degrees(ground.angle_deg)};
    std::vector<Area> areas;
    for (int entry = 0; entry < ground.entries; ++entry) {
        for (const config::Shape& shape :
             forest::ladder_of_slits(grid, slit, ground.gap_m, ground.lines_m, entry, ground.entries)) {
            areas.push_back({.number = static_cast<std::uint32_t>(areas.size()),
                             .order = entry,
                             .place = {{shape}, ground.stands}});
        }
    }
    return areas;
}

std::vector<Area> raw_areas(const Ground& ground, const forest::PatchGrid& grid, const ShapesOf& shapes_of,
                            const config::Place& place, config::Problems& problems) {
    switch (ground.where) {
        case Where::all:
            return {{.place = {{}, ground.stands}}};
        case Where::stands: {
            const std::set<std::uint32_t> present = stands_of(grid);
            const std::set<std::uint32_t> named{ground.stands.begin(), ground.stands.end()};
            std::vector<Area> areas;
            for (const std::uint32_t number : named.empty() ? present : named) {
                areas.push_back(
                    {.number = number, .order = static_cast<int>(areas.size()), .place = {{}, {number}}});
            }
            return areas;
        }
        case Where::strips:
            return shaped(forest::strips(grid, ground.width_m, direction_of(ground, grid), 0, 1), ground);
        case Where::slits:
            return slits_have_room(ground, place, problems) ? slits(ground, grid) : std::vector<Area>{};
        case Where::polygons:
            try {
                return shaped(shapes_of(ground.polygons, config::Shape::Kind::polygon), ground);
            } catch (const config::InputError& error) {
                problems.add(error);
            }
            return {};
        case Where::corridors:
            try {
                return corridors(shapes_of(ground.lines, config::Shape::Kind::line), ground);
            } catch (const config::InputError& error) {
                problems.add(error);
            }
            return {};
        case Where::cuts_of:
            return {};
    }
    return {};
}

}  // namespace

std::vector<config::Shape> shapes_in(const config::Table& table, config::Shape::Kind kind) {
    config::Problems problems;
    std::vector<config::Shape> shapes;
    if (table.require({"wkt"}, problems)) {
        for (std::size_t row = 0; row < table.rows(); ++row) {
            if (auto shape = shape_of(table, row, {kind}, problems)) {
                shapes.push_back(std::move(*shape));
            }
        }
    }
    problems.throw_if_any();
    return shapes;
}

std::vector<Area> areas_of(const Ground& ground, const forest::PatchGrid& grid, const ShapesOf& shapes_of,
                           const config::Place& place, config::Problems& problems) {
    const std::size_t problems_before = problems.list().size();
    const std::set<std::uint32_t> present = stands_of(grid);
    for (const std::uint32_t number : ground.stands) {
        if (!present.contains(number)) {
            problems.add(config::ExitCode::data, place, joined("stand ", std::to_string(number)),
                         "a stand of the stand map");
        }
    }
    std::vector<Area> areas = raw_areas(ground, grid, shapes_of, place, problems);
    for (Area& area : areas) {
        area.place.from_slope_deg = ground.from_slope_deg;
        area.place.to_slope_deg = ground.to_slope_deg;
        area.area_ha = forest::area_ha(grid, area.place);
        area.patches = forest::patches_in(grid, area.place);
    }
    std::erase_if(areas, [](const Area& area) { return area.area_ha <= 0.0; });
    if (areas.empty() && ground.where != Where::cuts_of && problems.list().size() == problems_before) {
        problems.add(config::ExitCode::data, place,
                     joined("where = ", name_of(ground.where), " meets no forest"),
                     "areas in the forest: room for slits and strips, and slopes between from_slope_deg and "
                     "to_slope_deg");
    }
    return areas;
}

}  // namespace coupling
