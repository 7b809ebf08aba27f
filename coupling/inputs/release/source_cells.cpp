#include "coupling/inputs/release/source_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/plausible/off_terrain.hpp"
#include "coupling/inputs/release/source_cover.hpp"
#include "coupling/inputs/release/zone_blocks.hpp"
#include "coupling/inputs/scenario/release_settings.hpp"
#include "coupling/inputs/scenario/terrain_settings.hpp"
#include "coupling/inputs/systems/extent.hpp"
#include "coupling/inputs/terrain/slope_tangent.hpp"
#include "rockfall/release/release.hpp"

namespace coupling {
namespace {

using config::joined;
using rockfall::ReleaseSource;

std::vector<config::Point2> vertices_of(const config::Shape& shape) {
    std::vector<config::Point2> vertices;
    for (const auto& part : shape.parts) {
        vertices.insert(vertices.end(), part.begin(), part.end());
    }
    return vertices;
}

/// By cell the release zone of a grid, or the number of the shape from 1: 0 or NaN none.
config::Raster<double> sources_on(const config::GridFrame& frame, const SourceInput& input) {
    if (input.grid) {
        return *input.grid;
    }
    if (input.everywhere) {
        return config::Raster<double>{frame, 1.0};
    }
    std::vector<config::CodedPolygon> areas;
    for (const SourceShape& source : input.shapes) {
        areas.push_back({source.shape, static_cast<double>(areas.size() + 1)});
    }
    return config::rasterise_polygons(frame, areas, 0.0);
}

bool is_in_ring(const config::Cell& cell, const config::GridFrame& frame) {
    return cell.column == 0 || cell.row == 0 || cell.column == frame.columns - 1 ||
           cell.row == frame.rows - 1;
}

/// Takes out the cells that are not steeper than `steeper_than_deg`; of all the terrain also its outer ring,
/// where it ends, and cells without ground, which nobody named.
void keep_steep(config::Raster<double>& cells, const SourceInput& input, const HeightInput& heights,
                const rockfall::Terrain& terrain, double steeper_than_deg) {
    const double least_tangent = tangent_of_deg(steeper_than_deg);
    for (std::size_t i = 0; i < cells.values.size(); ++i) {
        if (std::isnan(cells.values[i]) || cells.values[i] == 0.0) {
            continue;
        }
        const bool is_open = !input.everywhere || (has_ground(heights, cells.frame, terrain, i) &&
                                                   !is_in_ring(cells.frame.cell_of(i), cells.frame));
        if (!is_open || !(slope_tangent(heights, cells.frame, terrain, i).value_or(0.0) > least_tangent)) {
            cells.values[i] = 0.0;
        }
    }
}

/// True surface of a cell: plan area over the cosine of the slope, mean of four places. 0 off the terrain.
double surface_area_m2(const ReleaseSource& cell, const rockfall::Terrain& terrain) {
    const Eigen::Vector2d size_m = cell.last_m - cell.first_m;
    double sum = 0.0;
    int found = 0;
    for (const auto& [east, north] :
         std::array<std::array<double, 2>, 4>{{{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}}}) {
        const auto triangle =
            terrain.locate(cell.first_m.x() + east * size_m.x(), cell.first_m.y() + north * size_m.y());
        if (triangle) {
            sum += 1.0 / static_cast<double>(terrain.triangles()[*triangle].normal_z);
            ++found;
        }
    }
    return found == 0 ? 0.0 : size_m.x() * size_m.y() * sum / found;
}

ReleaseSource cell_source(const config::GridFrame& frame, std::size_t index, std::uint32_t zone,
                          const rockfall::Terrain& terrain) {
    const config::Cell cell = frame.cell_of(index);
    const Eigen::Vector2d half_m{0.5 * frame.cell_width_m, 0.5 * frame.cell_height_m};
    const Eigen::Vector2d centre_m =
        Eigen::Vector2d{frame.x_centre_m(cell.column), frame.y_centre_m(cell.row)} - terrain.origin_m();
    ReleaseSource source;
    source.kind = ReleaseSource::Kind::cell;
    source.first_m = centre_m - half_m;
    source.last_m = centre_m + half_m;
    source.zone = zone;
    source.weight = surface_area_m2(source, terrain);
    return source;
}

/// Source cells by what became of them.
struct CellCounts {
    std::size_t all = 0;
    std::size_t in_ring = 0;         ///< where the terrain ends
    std::size_t in_ring_stated = 0;  ///< of these: where terrain.extent_m ends
    std::size_t off_terrain = 0;
    std::size_t on_nodata = 0;
    std::size_t first_on_nodata = 0;
};

/// Whether the terrain ends at a cell of its outer ring because terrain.extent_m does.
bool ends_as_stated(const config::GridFrame& frame, const config::Cell& cell, const Reading& reading) {
    const auto outward = [](int at, int count) { return at == 0 ? -1.5 : at == count - 1 ? 1.5 : 0.0; };
    const config::Point2 beyond{
        frame.x_centre_m(cell.column) + outward(cell.column, frame.columns) * frame.cell_width_m,
        frame.y_centre_m(cell.row) - outward(cell.row, frame.rows) * frame.cell_height_m};
    return plausible::outside_of_stated_extent({&beyond, 1}, reading) > 0;
}

void warn_of_cells(const CellCounts& counts, const config::GridFrame& frame, const SourceInput& input,
                   const HeightInput& heights, Reading& reading) {
    if (counts.on_nodata > 0) {
        reading.refuse({input.file},
                       counted(counts.on_nodata, "source cell") + " on NODATA of " + heights.file +
                           ", the first in " + cell_in_words(frame, counts.first_on_nodata),
                       "heights all over the release area",
                       "take a terrain without gaps there, or take these cells out of the sources");
    }
    if (counts.in_ring_stated > 0) {
        reading.note(joined(input.file, ": ", counted(counts.in_ring_stated, "source cell"), " of ",
                            std::to_string(counts.all), " at the edge of terrain.extent_m, left out"));
    }
    if (const std::size_t unasked = counts.in_ring - counts.in_ring_stated; unasked > 0) {
        reading.warn({input.file},
                     counted(unasked, "source cell") + " of " + std::to_string(counts.all) +
                         " in the outer ring of " + heights.file + ", where the terrain ends; left out",
                     "sources at least one cell inside", "take a larger terrain if rocks start there");
    }
    if (counts.off_terrain > 0) {
        reading.warn({input.file},
                     counted(counts.off_terrain, "source cell") + " of " + std::to_string(counts.all) +
                         " off the terrain; left out",
                     "sources on the terrain", "take a larger terrain if rocks start there");
    }
}

/// Whether any centre of a cell lies in a polygon.
bool holds_a_centre(const config::GridFrame& frame, const config::Shape& polygon) {
    const plausible::Extent extent = plausible::extent_of(vertices_of(polygon));
    const config::Cell from = frame.cell_at(extent.west_m, extent.north_m);
    const config::Cell to = frame.cell_at(extent.east_m, extent.south_m);
    for (int row = std::max(0, from.row); row <= std::min(frame.rows - 1, to.row); ++row) {
        for (int column = std::max(0, from.column); column <= std::min(frame.columns - 1, to.column);
             ++column) {
            if (config::point_in_polygon(polygon, {frame.x_centre_m(column), frame.y_centre_m(row)})) {
                return true;
            }
        }
    }
    return false;
}

/// A polygon between the centres of the cells: a source of its own, whose rocks start inside it. Weight 0
/// where none of its ground is on the terrain.
ReleaseSource polygon_source(const SourceShape& shape, const rockfall::Terrain& terrain) {
    constexpr int side = 64;  // samples along each side of the rectangle about it [choice]
    auto outline = std::make_shared<rockfall::SourceOutline>();
    outline->polygon = shape.shape;
    for (auto& ring : outline->polygon.parts) {
        for (config::Point2& corner : ring) {
            corner = {corner.x_m - terrain.origin_m().x(), corner.y_m - terrain.origin_m().y()};
        }
    }
    const plausible::Extent extent = plausible::extent_of(vertices_of(outline->polygon));
    ReleaseSource source;
    source.kind = ReleaseSource::Kind::cell;
    source.first_m = {extent.west_m, extent.south_m};
    source.last_m = {extent.east_m, extent.north_m};
    source.zone = shape.zone;
    source.weight = 0.0;
    const Eigen::Vector2d step_m = (source.last_m - source.first_m) / side;
    const Eigen::Vector2d middle_m = 0.5 * (source.first_m + source.last_m);
    double nearest_m = std::numeric_limits<double>::infinity();
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const Eigen::Vector2d place =
                source.first_m + Eigen::Vector2d{(column + 0.5) * step_m.x(), (row + 0.5) * step_m.y()};
            if (!config::point_in_polygon(outline->polygon, {place.x(), place.y()})) {
                continue;
            }
            if (const auto triangle = terrain.locate(place.x(), place.y())) {
                const auto normal_z = static_cast<double>(terrain.triangles()[*triangle].normal_z);
                source.weight += step_m.x() * step_m.y() / normal_z;
                if (const double away_m = (place - middle_m).norm(); away_m < nearest_m) {
                    nearest_m = away_m;
                    outline->inner_m = place;
                }
            }
        }
    }
    source.outline = std::move(outline);
    return source;
}

/// The slope of the cell in which a source has its inner place.
bool is_steep(const ReleaseSource& source, const HeightInput& heights, const config::GridFrame& frame,
              const rockfall::Terrain& terrain, double steeper_than_deg) {
    const Eigen::Vector2d place = source.outline->inner_m + terrain.origin_m();
    const config::Cell cell = frame.cell_at(place.x(), place.y());
    return frame.contains(cell) && slope_tangent(heights, frame, terrain, frame.index(cell)).value_or(0.0) >
                                       tangent_of_deg(steeper_than_deg);
}

/// Gives polygons that hold no centre of a cell a source of their own, and says which lie under later rows.
void place_small_polygons(const SourceInput& input, const HeightInput& heights,
                          const config::GridFrame& frame, const rockfall::Terrain& terrain,
                          const std::vector<bool>& has_cell, Reading& reading, Placed& placed) {
    const double steeper_deg = reading.release().steeper_than_deg;
    std::size_t small = 0;
    for (std::size_t i = 0; i < input.shapes.size(); ++i) {
        const SourceShape& shape = input.shapes[i];
        const auto start = start_of(input, shape.zone, shape.start);
        if (has_cell[i] || !start) {
            continue;
        }
        if (plausible::later_twin(input, i) || holds_a_centre(frame, shape.shape)) {
            plausible::warn_of_covered_polygon(input, i, reading);
            continue;
        }
        ReleaseSource source = polygon_source(shape, terrain);
        if (!(source.weight > 0.0)) {
            reading.refuse(shape.place,
                           joined("a source polygon of zone ", std::to_string(shape.zone), " without area"),
                           "polygons with an area", "draw a line instead");
            continue;
        }
        if (steeper_deg > 0.0 && !is_steep(source, heights, frame, terrain, steeper_deg)) {
            continue;
        }
        ++small;
        placed.add(std::move(source), *start, input);
    }
    if (small > 0) {
        reading.note(joined(input.file, ": ", counted(small, "source polygon"), " of ",
                            std::to_string(input.shapes.size()),
                            " between the centres of the cells: rocks start at random inside"));
    }
}

}  // namespace

Placed place_cells(const SourceInput& input, const HeightInput& heights, const rockfall::Terrain& terrain,
                   Reading& reading) {
    config::Raster<double> cells = sources_on(heights.frame(), input);
    std::vector<bool> has_cell(input.shapes.size(), false);  // before flat cells are taken out
    for (const double number : cells.values) {
        if (!input.shapes.empty() && number > 0.0) {
            has_cell[static_cast<std::size_t>(number) - 1] = true;
        }
    }
    if (const double steeper_deg = reading.release().steeper_than_deg; steeper_deg > 0.0) {
        keep_steep(cells, input, heights, terrain, steeper_deg);
    }
    const config::GridFrame& frame = cells.frame;
    const bool has_zones = input.grid.has_value() || input.everywhere;
    Placed placed;
    CellCounts counts;
    for (std::size_t index = 0; index < cells.values.size(); ++index) {
        const double number = cells.values[index];
        if (std::isnan(number) || number == 0.0) {
            continue;
        }
        ++counts.all;
        const SourceShape* shape = has_zones ? nullptr : &input.shapes[static_cast<std::size_t>(number) - 1];
        const auto zone = shape == nullptr ? static_cast<std::uint32_t>(number) : shape->zone;
        const auto start = start_of(input, zone, shape == nullptr ? 0 : shape->start);
        if (!start) {
            continue;
        }
        if (heights.grid && is_in_ring(frame.cell_of(index), frame)) {
            ++counts.in_ring;
            counts.in_ring_stated += ends_as_stated(frame, frame.cell_of(index), reading) ? 1U : 0U;
        } else if (heights.grid && std::isnan(heights.grid->values[index])) {
            counts.first_on_nodata = counts.on_nodata == 0 ? index : counts.first_on_nodata;
            ++counts.on_nodata;
        } else if (ReleaseSource source = cell_source(frame, index, zone, terrain); source.weight > 0.0) {
            placed.add(std::move(source), *start, input);
        } else {
            ++counts.off_terrain;
        }
    }
    warn_of_cells(counts, frame, input, heights, reading);
    if (!has_zones) {
        place_small_polygons(input, heights, frame, terrain, has_cell, reading, placed);
    }
    return placed;
}

}  // namespace coupling
