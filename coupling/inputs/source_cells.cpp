#include "coupling/inputs/source_cells.hpp"

#include <array>
#include <cmath>

#include "config/text/numbers.hpp"
#include "coupling/inputs/plausible/source_cover.hpp"
#include "coupling/inputs/slope_tangent.hpp"
#include "coupling/inputs/zone_blocks.hpp"

namespace coupling {
namespace {

using rockfall::ReleaseSource;

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
    std::size_t in_ring = 0;
    std::size_t off_terrain = 0;
    std::size_t on_nodata = 0;
    std::size_t first_on_nodata = 0;
};

void warn_of_cells(const CellCounts& counts, const config::GridFrame& frame, const SourceInput& input,
                   const HeightInput& heights, Reading& reading) {
    if (counts.on_nodata > 0) {
        reading.refuse({input.file},
                       counted(counts.on_nodata, "source cell") + " on NODATA of " + heights.file +
                           ", the first in " + cell_in_words(frame, counts.first_on_nodata),
                       "heights all over the release area",
                       "take a terrain without gaps there, or take these cells out of the sources");
    }
    if (counts.in_ring > 0) {
        reading.warn({input.file},
                     counted(counts.in_ring, "source cell") + " of " + std::to_string(counts.all) +
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

}  // namespace

Placed place_cells(const SourceInput& input, const HeightInput& heights, const rockfall::Terrain& terrain,
                   Reading& reading) {
    config::Raster<double> cells = sources_on(heights.frame(), input);
    if (const double steeper_deg = reading.scenario().steeper_than_deg; steeper_deg > 0.0) {
        keep_steep(cells, input, heights, terrain, steeper_deg);
    }
    const config::GridFrame& frame = cells.frame;
    const bool has_zones = input.grid.has_value() || input.everywhere;
    Placed placed;
    CellCounts counts;
    std::vector<std::size_t> cells_of_shape(input.shapes.size(), 0);
    for (std::size_t index = 0; index < cells.values.size(); ++index) {
        const double number = cells.values[index];
        if (std::isnan(number) || number == 0.0) {
            continue;
        }
        ++counts.all;
        if (!has_zones) {
            ++cells_of_shape[static_cast<std::size_t>(number) - 1];
        }
        const SourceShape* shape = has_zones ? nullptr : &input.shapes[static_cast<std::size_t>(number) - 1];
        const auto zone = shape == nullptr ? static_cast<std::uint32_t>(number) : shape->zone;
        const auto start = start_of(input, zone, shape == nullptr ? 0 : shape->start);
        if (!start) {
            continue;
        }
        if (heights.grid && is_in_ring(frame.cell_of(index), frame)) {
            ++counts.in_ring;
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
    plausible::doubt_polygons_without_cell(input, cells_of_shape, reading);
    return placed;
}

}  // namespace coupling
