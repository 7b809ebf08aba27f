#include "coupling/inputs/release_input.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/doubtful_columns.hpp"
#include "coupling/inputs/plausible/source_cover.hpp"
#include "coupling/inputs/shape_input.hpp"
#include "coupling/inputs/surface_input.hpp"
#include "coupling/inputs/zone_blocks.hpp"

namespace coupling {
namespace {

using config::joined;
using config::Shape;
using rockfall::ReleaseSource;
using Sources = std::vector<ReleaseSource>;

constexpr double most_zones = 4e9;  // zones are counted in 32 bits

SourceInput read_shapes(Reading& reading) {
    const std::string& name = reading.scenario().source_shapes;
    const config::Table table = reading.table("release.source_shapes", "source_shapes", name);
    config::Problems problems;
    table.require({"wkt"}, problems);
    problems.throw_if_any();
    std::vector<std::string> known = start_columns();
    known.emplace_back("wkt");
    doubt_columns(table, known, reading);
    SourceInput input{
        .grid = {}, .shapes = {}, .starts = {}, .file = table.file(), .has_zones = table.has("zone")};
    for (std::size_t row = 0; row < table.rows(); ++row) {
        auto shape =
            shape_of(table, row, {Shape::Kind::point, Shape::Kind::line, Shape::Kind::polygon}, problems);
        const auto zone = table.has("zone")
                              ? table.whole(row, "zone", {.low = 1.0, .high = most_zones}, problems)
                              : std::optional{static_cast<long long>(row + 1)};
        SourceStart start = read_source_start(table, row, reading.scenario(), problems);
        if (!shape || !zone) {
            continue;
        }
        if (!input.shapes.empty() && input.shapes.front().shape.kind != shape->kind) {
            problems.add(
                config::ExitCode::data, table.place(row, "wkt"), "another kind of shape than above",
                "one kind in a file: points share the rocks evenly, lines by length, polygons by area");
            continue;
        }
        input.shapes.push_back({static_cast<std::uint32_t>(*zone), std::move(*shape), table.place(row, "wkt"),
                                input.starts.size()});
        input.starts.push_back(std::move(start));
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
    SourceInput input{.grid = reading.grid("release.source", "source", name),
                      .shapes = {},
                      .starts = std::vector<SourceStart>(1),
                      .file = reading.shown(name)};
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

/// By cell the release zone of a grid, or the number of the shape from 1: 0 or NaN none.
config::Raster<double> sources_on(const config::GridFrame& frame, const SourceInput& input) {
    if (input.grid) {
        return *input.grid;
    }
    std::vector<config::CodedPolygon> areas;
    for (const SourceShape& source : input.shapes) {
        areas.push_back({source.shape, static_cast<double>(areas.size() + 1)});
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
        reading.doubt({input.file},
                      counted(counts.in_ring, "source cell") + " of " + std::to_string(counts.all) +
                          " in the outer ring of " + heights.file + ", where the terrain ends; left out",
                      "sources at least one cell inside", "take a larger terrain if rocks start there");
    }
    if (counts.off_terrain > 0) {
        reading.doubt({input.file},
                      counted(counts.off_terrain, "source cell") + " of " + std::to_string(counts.all) +
                          " off the terrain; left out",
                      "sources on the terrain", "take a larger terrain if rocks start there");
    }
}

/// Sources and, for each, which of the starts of the input is its own.
struct Placed {
    Sources sources;
    std::vector<std::size_t> rows;

    void add(ReleaseSource source, std::size_t start, const SourceInput& input) {
        source.own_start = input.starts[start].law;
        sources.push_back(std::move(source));
        rows.push_back(start);
    }
};

Placed place_cells(const SourceInput& input, const HeightInput& heights, const rockfall::Terrain& terrain,
                   Reading& reading) {
    const config::Raster<double> cells = sources_on(heights.frame(), input);
    const config::GridFrame& frame = cells.frame;
    Placed placed;
    CellCounts counts;
    std::vector<std::size_t> cells_of_shape(input.shapes.size(), 0);
    for (std::size_t index = 0; index < cells.values.size(); ++index) {
        const double number = cells.values[index];
        if (std::isnan(number) || number == 0.0) {
            continue;
        }
        ++counts.all;
        if (!input.grid) {
            ++cells_of_shape[static_cast<std::size_t>(number) - 1];
        }
        const SourceShape* shape = input.grid ? nullptr : &input.shapes[static_cast<std::size_t>(number) - 1];
        const auto zone = shape == nullptr ? static_cast<std::uint32_t>(number) : shape->zone;
        const auto start = start_of(input, zone, shape == nullptr ? 0 : shape->start);
        if (!start) {
            continue;
        }
        const config::Cell cell = frame.cell_of(index);
        const bool in_ring = cell.column == 0 || cell.row == 0 || cell.column == frame.columns - 1 ||
                             cell.row == frame.rows - 1;
        if (heights.grid && in_ring) {
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

/// Where a line first leaves the terrain, looked at in steps of half a metre; nothing if it stays on it.
std::optional<config::Point2> leaves_terrain_at(const std::vector<config::Point2>& line,
                                                const rockfall::Terrain& terrain) {
    constexpr double step_m = 0.5;
    std::uint32_t hint = rockfall::no_triangle;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const config::Point2& to = line[i];
        const config::Point2& from = i > 0 ? line[i - 1] : to;
        const double length_m = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
        const int steps = std::max(1, static_cast<int>(std::ceil(length_m / step_m)));
        for (int k = 1; k <= steps; ++k) {
            const double share = static_cast<double>(k) / steps;
            const config::Point2 place{from.x_m + share * (to.x_m - from.x_m),
                                       from.y_m + share * (to.y_m - from.y_m)};
            const auto triangle =
                terrain.locate(place.x_m - terrain.origin_m().x(), place.y_m - terrain.origin_m().y(), hint);
            if (!triangle) {
                return place;
            }
            hint = *triangle;
        }
    }
    return std::nullopt;
}

std::string to_dm(double value_m) {
    return config::to_text(std::round(10.0 * value_m) / 10.0);
}

/// The pieces of a line, or a problem where it leaves the terrain.
void place_line(const SourceInput& input, const SourceShape& shape, std::size_t start,
                const std::vector<config::Point2>& line, const rockfall::Terrain& terrain, Reading& reading,
                Placed& placed) {
    if (const auto place = leaves_terrain_at(line, terrain)) {
        reading.refuse(shape.place,
                       "a line that leaves the terrain at " + to_dm(place->x_m) + ", " + to_dm(place->y_m),
                       "lines of sources on the terrain", "cut the line at the border of the terrain");
        return;
    }
    for (std::size_t i = 1; i < line.size(); ++i) {
        if (line[i] != line[i - 1]) {
            ReleaseSource piece = line_source(line[i - 1], line[i], shape.zone, terrain);
            piece.evenly = input.starts[start].blocks.has_value();
            placed.add(std::move(piece), start, input);
        }
    }
}

/// Points alone, lines piece by piece.
Placed place_pieces(const SourceInput& input, const rockfall::Terrain& terrain, Reading& reading) {
    Placed placed;
    std::size_t points = 0;
    for (const SourceShape& source : input.shapes) {
        const auto start = start_of(input, source.zone, source.start);
        if (!start) {
            continue;
        }
        for (const auto& part : source.shape.parts) {
            if (source.shape.kind == Shape::Kind::line) {
                place_line(input, source, *start, part, terrain, reading, placed);
                continue;
            }
            ++points;
            ReleaseSource point = line_source(part.front(), part.front(), source.zone, terrain);
            if (terrain.locate(point.first_m.x(), point.first_m.y())) {
                placed.add(std::move(point), *start, input);
            }
        }
    }
    if (points > 0 && placed.sources.size() < points) {
        reading.doubt({input.file},
                      std::to_string(points - placed.sources.size()) + " of " + counted(points, "source") +
                          " off the terrain; left out",
                      "sources on the terrain", "correct their coordinates, or remove them");
    }
    return placed;
}

}  // namespace

std::optional<SourceInput> read_sources(Reading& reading) {
    return reading.attempt([&] {
        SourceInput input = reading.scenario().source.empty() ? read_shapes(reading) : read_grid(reading);
        if (!reading.scenario().hazard.blocks.empty()) {
            take_zone_blocks(input, reading);
        }
        return input;
    });
}

std::optional<Sources> place_sources(const SourceInput& input, const HeightInput& heights,
                                     const rockfall::Terrain& terrain, Reading& reading) {
    if (input.grid && heights.grid && !check_frame(input.grid->frame, input.file, heights, reading)) {
        return std::nullopt;
    }
    const bool in_cells =
        input.grid || (!input.shapes.empty() && input.shapes.front().shape.kind == Shape::Kind::polygon);
    const std::size_t problems_before = reading.problems().list().size();
    plausible::judge_source_shapes(input, terrain, reading);
    if (reading.problems().list().size() > problems_before) {
        return std::nullopt;
    }
    Placed placed =
        in_cells ? place_cells(input, heights, terrain, reading) : place_pieces(input, terrain, reading);
    if (reading.problems().list().size() > problems_before) {
        return std::nullopt;
    }
    if (placed.sources.empty() && input.by_zone) {
        reading.refuse(
            {reading.shown(reading.scenario().hazard.blocks)},
            joined("no zone with rocks of ", config::to_text(reading.scenario().hazard.return_period_years),
                   " years that has a source on the terrain"),
            "zones of the sources");
        return std::nullopt;
    }
    if (placed.sources.empty()) {
        reading.refuse(
            {input.file}, "no source of rocks that lies on the terrain",
            input.grid ? "at least one cell above 0 inside the outer ring" : "at least one on the terrain",
            "check that the file holds the sources, and a terrain that reaches beyond them");
        return std::nullopt;
    }
    share_rocks(placed.sources, placed.rows, input.starts, reading);
    if (input.by_zone) {
        doubt_zones_without_rocks(placed.sources, reading);
    }
    return reading.problems().list().size() > problems_before ? std::nullopt
                                                              : std::optional{std::move(placed.sources)};
}

rockfall::DiameterRange diameters_of(const std::optional<SourceInput>& input, const Scenario& scenario) {
    const rockfall::StartLaw common = start_law(scenario);
    std::vector<ReleaseSource> sources;
    for (std::size_t row = 0; input && row < input->starts.size(); ++row) {
        ReleaseSource& source = sources.emplace_back();
        source.own_start = input->starts[row].law;
        source.rocks = 1;
    }
    return rockfall::diameter_range(common, sources);
}

}  // namespace coupling
