#include "coupling/inputs/release/release_input.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/release/source_cells.hpp"
#include "coupling/inputs/release/source_cover.hpp"
#include "coupling/inputs/release/zone_blocks.hpp"
#include "coupling/inputs/scenario/hazard_settings.hpp"
#include "coupling/inputs/scenario/release_settings.hpp"
#include "coupling/inputs/terrain/surface_input.hpp"

namespace coupling {
namespace {

using config::joined;
using config::Shape;
using rockfall::ReleaseSource;
using Sources = std::vector<ReleaseSource>;

constexpr double most_zones = 4e9;  // zones are counted in 32 bits

/// The hulls that single rows name are inputs of the run too: each file is recorded once.
void record_hulls(const config::Table& table, std::set<std::string>& recorded, Reading& reading) {
    for (std::size_t row = 0; table.has("shape_file") && row < table.rows(); ++row) {
        const std::string& name = table.text(row, "shape_file");
        if (recorded.insert(name).second) {
            reading.open_at(table.place(row, "shape_file"),
                            joined("block_shape ", std::to_string(recorded.size() - 2)), name,
                            "a hull: points as CSV, PLY or STL");
        }
    }
}

/// Whether rows name their zones: layers that were drawn have all columns, filled in or not.
bool names_zones(const config::Table& table) {
    if (!table.has("zone")) {
        return false;
    }
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (!table.text(row, "zone").empty()) {
            return true;
        }
    }
    return false;
}

/// Adds the sources of one of several files.
void add_shapes(const config::Table& table, Reading& reading, SourceInput& input) {
    if (!input.shapes.empty() && input.has_zones != names_zones(table)) {
        config::fail(config::ExitCode::data, {table.file()},
                     input.has_zones ? "no column zone" : "a column zone",
                     joined("the same as in ", input.file),
                     "give all files of sources a column zone, or none of them");
    }
    input.has_zones = names_zones(table);
    const std::size_t before = input.shapes.size();
    config::RowProblems wrong{table};
    for (config::Read<SourceRow>& row : source_shape_columns().rows(table, wrong)) {
        if (input.has_zones && !row.zone) {
            wrong.refuse(row.row, "zone", "zone empty", "a zone for each source, or no column zone");
        }
        SourceStart start = read_source_start(row, reading, wrong);
        if (!input.shapes.empty() && input.shapes.front().shape.kind != row.shape.kind) {
            wrong.refuse(row.row, "wkt", "another kind of shape than above",
                         "one kind in all files of sources: points share the rocks evenly, lines by length, "
                         "polygons by area");
            continue;
        }
        input.shapes.push_back({row.zone.value_or(static_cast<std::uint32_t>(before + row.row + 1)),
                                std::move(row.shape), table.place(row.row, "wkt"), input.starts.size()});
        input.starts.push_back(std::move(start));
    }
    wrong.throw_first();
}

SourceInput read_shapes(Reading& reading) {
    const std::vector<NamedTable> names = tables_in(reading.release().source_shapes);
    SourceInput input{.grid = {},
                      .shapes = {},
                      .starts = {},
                      .file = reading.shown(names.front().name),
                      .has_zones = false};
    std::set<std::string> recorded{reading.release().shapes.file, ""};
    for (const NamedTable& name : names) {
        const config::Table table = table_of(source_shape_columns(), name.name, reading);
        record_hulls(table, recorded, reading);
        add_shapes(table, reading, input);
    }
    return input;
}

/// All the terrain, of which only the steep cells are sources.
SourceInput everywhere() {
    return {.grid = {},
            .shapes = {},
            .starts = std::vector<SourceStart>(1),
            .file = "release.steeper_than_deg",
            .everywhere = true};
}

bool is_zone(double value) {
    return std::isnan(value) || (value >= 0.0 && value <= most_zones && value == std::floor(value));
}

SourceInput read_grid(Reading& reading) {
    const std::string& name = reading.release().source;
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
        reading.warn({input.file},
                     std::to_string(points - placed.sources.size()) + " of " + counted(points, "source") +
                         " off the terrain; left out",
                     "sources on the terrain", "correct their coordinates, or remove them");
    }
    return placed;
}

}  // namespace

std::optional<SourceInput> read_sources(Reading& reading) {
    return reading.attempt([&] {
        if (!reading.release().shapes.file.empty()) {
            reading.open("release.shape_file", "block_shape", reading.release().shapes.file,
                         "a hull: points as CSV, PLY or STL");
        }
        SourceInput input = !reading.release().source.empty()          ? read_grid(reading)
                            : !reading.release().source_shapes.empty() ? read_shapes(reading)
                                                                       : everywhere();
        if (reading.release().steeper_than_deg > 0.0 && !input.shapes.empty() &&
            input.shapes.front().shape.kind != Shape::Kind::polygon) {
            config::fail(config::ExitCode::settings,
                         reading.settings().options->place_of("release.steeper_than_deg"),
                         "release.steeper_than_deg beside points or lines of release.source_shapes",
                         "polygons or a grid: only cells have a slope", "remove one of the two");
        }
        if (!reading.hazard().blocks.empty()) {
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
    const bool in_cells = input.grid || input.everywhere ||
                          (!input.shapes.empty() && input.shapes.front().shape.kind == Shape::Kind::polygon);
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
        reading.refuse({reading.shown(reading.hazard().blocks)},
                       joined("no zone with rocks of ", config::to_text(reading.hazard().return_period_years),
                              " years that has a source on the terrain"),
                       "zones of the sources");
        return std::nullopt;
    }
    if (const double steeper_deg = reading.release().steeper_than_deg;
        placed.sources.empty() && steeper_deg > 0.0) {
        reading.refuse(reading.settings().options->place_of("release.steeper_than_deg"),
                       joined("no source cell steeper than ", config::to_text(steeper_deg), " degrees"),
                       "a smaller angle, or sources from a file",
                       "look at the slopes of the terrain (QGIS: Slope)");
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

rockfall::DiameterRange diameters_of(const std::optional<SourceInput>& input,
                                     const ReleaseSettings& release) {
    const rockfall::StartLaw common = start_law(release);
    std::vector<ReleaseSource> sources;
    for (std::size_t row = 0; input && row < input->starts.size(); ++row) {
        ReleaseSource& source = sources.emplace_back();
        source.own_start = input->starts[row].law;
        source.rocks = 1;
    }
    return rockfall::diameter_range(common, sources);
}

}  // namespace coupling
