#include "coupling/inputs/release_input.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "config/text/numbers.hpp"
#include "coupling/inputs/shape_input.hpp"
#include "coupling/inputs/surface_input.hpp"

namespace coupling {

namespace {

using config::Shape;
using rockfall::ReleaseSource;
using Sources = std::vector<ReleaseSource>;

constexpr double most_zones = 4e9;  // zones and rocks of a source are counted in 32 bits
constexpr std::uint64_t most_rocks = 4'000'000'000ULL;

SourceInput read_shapes(Reading& reading) {
    const std::string& name = reading.scenario().source_shapes;
    const config::Table table = reading.table("release.source_shapes", "source_shapes", name);
    config::Problems problems;
    table.require({"wkt"}, problems);
    problems.throw_if_any();
    SourceInput input{.grid = {}, .shapes = {}, .file = table.file()};
    for (std::size_t row = 0; row < table.rows(); ++row) {
        auto shape =
            shape_of(table, row, {Shape::Kind::point, Shape::Kind::line, Shape::Kind::polygon}, problems);
        const auto zone = table.has("zone")
                              ? table.whole(row, "zone", {.low = 1.0, .high = most_zones}, problems)
                              : std::optional{static_cast<long long>(row + 1)};
        if (!shape || !zone) {
            continue;
        }
        if (!input.shapes.empty() && input.shapes.front().shape.kind != shape->kind) {
            problems.add(
                config::ExitCode::data, table.place(row, "wkt"), "another kind of shape than above",
                "one kind in a file: points share the rocks evenly, lines by length, polygons by area");
            continue;
        }
        input.shapes.push_back({static_cast<std::uint32_t>(*zone), std::move(*shape)});
    }
    config::Problems shown;
    add_first(shown, problems, table.file());
    shown.throw_if_any();
    return input;
}

bool is_zone(double value) {
    return std::isnan(value) || (value >= 0.0 && value <= most_zones && value == std::floor(value));
}

SourceInput read_grid(Reading& reading) {
    const std::string& name = reading.scenario().source;
    SourceInput input{
        .grid = reading.grid("release.source", "source", name), .shapes = {}, .file = reading.shown(name)};
    const auto& values = input.grid->values;
    const auto bad = std::find_if_not(values.begin(), values.end(), is_zone);
    if (bad != values.end()) {
        const auto count = values.end() - bad - std::count_if(bad, values.end(), is_zone);
        config::fail(config::ExitCode::data, {input.file},
                     config::to_text(*bad) + " in " + counted(static_cast<std::size_t>(count), "cell") +
                         ", the first in " +
                         cell_in_words(input.grid->frame, static_cast<std::size_t>(bad - values.begin())),
                     "whole numbers: 0 for no source, 1, 2, ... for release zones");
    }
    return input;
}

/// Release zone by cell: 0 or NaN none.
config::Raster<double> zones_on(const config::GridFrame& frame, const SourceInput& input) {
    if (input.grid) {
        return *input.grid;
    }
    std::vector<config::CodedPolygon> areas;
    for (const SourceShape& source : input.shapes) {
        areas.push_back({source.shape, static_cast<double>(source.zone)});
    }
    return config::rasterise_polygons(frame, areas, 0.0);
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

ReleaseSource cell_source(const config::GridFrame& frame, std::size_t index, double zone,
                          const rockfall::Terrain& terrain) {
    const config::Cell cell = frame.cell_of(index);
    const Eigen::Vector2d half_m{0.5 * frame.cell_width_m, 0.5 * frame.cell_height_m};
    const Eigen::Vector2d centre_m =
        Eigen::Vector2d{frame.x_centre_m(cell.column), frame.y_centre_m(cell.row)} - terrain.origin_m();
    ReleaseSource source;
    source.kind = ReleaseSource::Kind::cell;
    source.first_m = centre_m - half_m;
    source.last_m = centre_m + half_m;
    source.zone = static_cast<std::uint32_t>(zone);
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

void tell(const CellCounts& counts, const config::GridFrame& frame, const SourceInput& input,
          const HeightInput& heights, Reading& reading) {
    if (counts.on_nodata > 0) {
        reading.refuse({input.file},
                       counted(counts.on_nodata, "source cell") + " on NODATA of " + heights.file +
                           ", the first in " + cell_in_words(frame, counts.first_on_nodata),
                       "heights all over the release area");
    }
    if (counts.in_ring > 0) {
        reading.doubt({input.file},
                      counted(counts.in_ring, "source cell") + " of " + std::to_string(counts.all) +
                          " in the outer ring of " + heights.file + ", where the terrain ends; left out",
                      "sources at least one cell inside");
    }
    if (counts.off_terrain > 0) {
        reading.doubt({input.file},
                      counted(counts.off_terrain, "source cell") + " of " + std::to_string(counts.all) +
                          " off the terrain; left out",
                      "sources on the terrain");
    }
}

Sources place_cells(const SourceInput& input, const HeightInput& heights, const rockfall::Terrain& terrain,
                    Reading& reading) {
    const config::Raster<double> zones = zones_on(heights.frame(), input);
    const config::GridFrame& frame = zones.frame;
    Sources sources;
    CellCounts counts;
    for (std::size_t index = 0; index < zones.values.size(); ++index) {
        const double zone = zones.values[index];
        if (std::isnan(zone) || zone == 0.0) {
            continue;
        }
        ++counts.all;
        const config::Cell cell = frame.cell_of(index);
        const bool in_ring = cell.column == 0 || cell.row == 0 || cell.column == frame.columns - 1 ||
                             cell.row == frame.rows - 1;
        if (heights.grid && in_ring) {
            ++counts.in_ring;
        } else if (heights.grid && std::isnan(heights.grid->values[index])) {
            counts.first_on_nodata = counts.on_nodata == 0 ? index : counts.first_on_nodata;
            ++counts.on_nodata;
        } else if (const ReleaseSource source = cell_source(frame, index, zone, terrain);
                   source.weight > 0.0) {
            sources.push_back(source);
        } else {
            ++counts.off_terrain;
        }
    }
    tell(counts, frame, input, heights, reading);
    return sources;
}

ReleaseSource line_source(const config::Point2& from, const config::Point2& to, std::uint32_t zone,
                          const rockfall::Terrain& terrain) {
    ReleaseSource source;
    source.kind = ReleaseSource::Kind::line;
    source.first_m = Eigen::Vector2d{from.x_m, from.y_m} - terrain.origin_m();
    source.last_m = Eigen::Vector2d{to.x_m, to.y_m} - terrain.origin_m();
    source.zone = zone;
    const double length_m = (source.last_m - source.first_m).norm();
    source.weight = length_m > 0.0 ? length_m : 1.0;
    return source;
}

/// Points alone, lines piece by piece.
Sources pieces_of(const SourceInput& input, const rockfall::Terrain& terrain) {
    Sources sources;
    for (const auto& [zone, shape] : input.shapes) {
        for (const auto& part : shape.parts) {
            if (shape.kind == Shape::Kind::point) {
                sources.push_back(line_source(part.front(), part.front(), zone, terrain));
            }
            for (std::size_t i = 1; shape.kind == Shape::Kind::line && i < part.size(); ++i) {
                if (part[i] != part[i - 1]) {
                    sources.push_back(line_source(part[i - 1], part[i], zone, terrain));
                }
            }
        }
    }
    return sources;
}

Sources place_pieces(const SourceInput& input, const rockfall::Terrain& terrain, Reading& reading) {
    Sources sources = pieces_of(input, terrain);
    const std::size_t all = sources.size();
    std::erase_if(sources, [&](const ReleaseSource& source) {
        const Eigen::Vector2d middle_m = 0.5 * (source.first_m + source.last_m);
        return !terrain.locate(middle_m.x(), middle_m.y());
    });
    if (sources.size() < all) {
        reading.doubt({input.file},
                      std::to_string(all - sources.size()) + " of " + counted(all, "source") +
                          " off the terrain; left out",
                      "sources on the terrain");
    }
    return sources;
}

}  // namespace

std::optional<SourceInput> read_sources(Reading& reading) {
    return reading.attempt(
        [&] { return reading.scenario().source.empty() ? read_shapes(reading) : read_grid(reading); });
}

std::optional<Sources> place_sources(const SourceInput& input, const HeightInput& heights,
                                     const rockfall::Terrain& terrain, Reading& reading) {
    if (input.grid && !check_frame(input.grid->frame, input.file, heights, reading)) {
        return std::nullopt;
    }
    const bool in_cells =
        input.grid || (!input.shapes.empty() && input.shapes.front().shape.kind == Shape::Kind::polygon);
    const std::size_t problems_before = reading.problems().list().size();
    Sources sources =
        in_cells ? place_cells(input, heights, terrain, reading) : place_pieces(input, terrain, reading);
    if (reading.problems().list().size() > problems_before) {
        return std::nullopt;
    }
    if (sources.empty()) {
        reading.refuse(
            {input.file}, "no source of rocks that lies on the terrain",
            input.grid ? "at least one cell above 0 inside the outer ring" : "at least one on the terrain");
        return std::nullopt;
    }
    const Scenario& scenario = reading.scenario();
    const std::uint64_t rocks =
        scenario.rocks > 0 ? scenario.rocks : scenario.rocks_per_source * sources.size();
    if (rocks > most_rocks) {
        reading.refuse(scenario.options->place_of("release.rocks_per_source"),
                       counted(rocks, "rock") + " from " + counted(sources.size(), "source"),
                       "at most " + std::to_string(most_rocks) + " in one run");
        return std::nullopt;
    }
    rockfall::allot(sources, rocks);
    return sources;
}

}  // namespace coupling
