#include "coupling/inputs/terrain/surface_input.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "config/text/coordinates.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/plain_letters.hpp"
#include "coupling/inputs/grids/filled_holes.hpp"
#include "coupling/inputs/ground/ground_names.hpp"
#include "coupling/inputs/ground/surface_types.hpp"
#include "coupling/inputs/plausible/beyond_terrain.hpp"
#include "coupling/inputs/plausible/cut_command.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/scenario/terrain_settings.hpp"
#include "coupling/inputs/terrain/slope_tangent.hpp"

namespace coupling {

using config::joined;

struct SurfacePolygonRow {
    std::string code;
    config::Shape shape;
};

const config::Schema<SurfacePolygonRow>& surface_polygon_columns() {
    // clang-format off
    static const config::Schema<SurfacePolygonRow> columns{
        {.role = "surface_polygons", .setting = "terrain.surface_polygons", .row = "area"},
        {{"code", &SurfacePolygonRow::code, "of terrain.surface_types, or a label there"},
         {"wkt", &SurfacePolygonRow::shape, "later rows lie on top", {.shapes = {config::Shape::Kind::polygon}}}}};
    // clang-format on
    return columns;
}

struct SlopeGroundRow {
    double from_deg = 0.0;
};

const config::Schema<SlopeGroundRow>& slope_ground_columns() {
    // clang-format off
    static const config::Schema<SlopeGroundRow> columns{
        {.role = "slope_grounds", .setting = "terrain.slope_grounds", .row = "slope class", .no_rows = "at least one row: from_deg, surface"},
        {{"from_deg", &SlopeGroundRow::from_deg, "the class reaches from here to the next", {.range = {0.0, 89.0}}},
         {"surface", "a shipped ground type or a code of terrain.surface_types"}}};
    // clang-format on
    return columns;
}

namespace {

constexpr double no_code = std::numeric_limits<double>::quiet_NaN();

GroundCover read_polygons(Reading& reading) {
    const std::vector<NamedTable> tables = tables_in(reading.terrain().surface_polygons);
    GroundCover cover{.grid = {}, .areas = {}, .file = reading.shown(tables.front().name)};
    for (const NamedTable& name : tables) {
        const config::Table table = table_of(surface_polygon_columns(), name.name, reading);
        config::RowProblems wrong{table};
        for (config::Read<SurfacePolygonRow>& row : surface_polygon_columns().rows(table, wrong)) {
            const std::optional<double> code = config::parse_number(row.code);
            if (!code) {
                cover.words.push_back({cover.areas.size(), row.code, table.place(row.row, "code")});
            } else if (!(*code >= 0.0) || *code != std::floor(*code)) {
                wrong.refuse(row.row, "code", joined("code ", config::in_quotes(row.code)),
                             "a whole number >= 0, or a label of terrain.surface_types");
            }
            cover.areas.push_back({std::move(row.shape), code.value_or(no_code)});
        }
        wrong.throw_first();
    }
    return cover;
}

GroundCover read_cover(Reading& reading) {
    if (!reading.terrain().surface_polygons.empty()) {
        return read_polygons(reading);
    }
    GroundCover cover;
    if (!reading.terrain().surface.empty()) {
        cover.file = reading.shown(reading.terrain().surface);
        cover.grid = reading.grid("terrain.surface", "surface", reading.terrain().surface);
    }
    return cover;
}

GroundCover read_cover_and_classes(Reading& reading) {
    GroundCover cover = read_cover(reading);
    const std::string& name = reading.terrain().slope_grounds;
    if (!name.empty()) {
        cover.by_slope = table_of(slope_ground_columns(), name, reading);
    }
    return cover;
}

/// Classes of slope and the ground type of each.
class SlopeClasses {
public:
    /// Throws InputError (data) for classes that do not rise and for unknown ground types.
    static SlopeClasses read(const config::Table& table, GroundNames& names) {
        SlopeClasses classes;
        config::RowProblems wrong{table};
        double before_deg = -1.0;
        for (const config::Read<SlopeGroundRow>& row : slope_ground_columns().rows(table, wrong)) {
            const auto type = names.place_of(table, row.row, "from_deg", wrong);
            if (row.from_deg <= before_deg) {
                wrong.refuse(
                    row.row, "from_deg",
                    "from_deg " + table.text(row.row, "from_deg") + " after " + config::to_text(before_deg),
                    "classes from flat to steep, each once", "sort the rows by from_deg");
            }
            before_deg = row.from_deg;
            classes.list_.push_back({tangent_of_deg(row.from_deg), type.value_or(0)});
        }
        wrong.throw_first();
        return classes;
    }
    /// The type of the steepest class that begins at or below this slope.
    [[nodiscard]] std::optional<std::uint8_t> at(std::optional<double> tangent) const {
        std::optional<std::uint8_t> type;
        for (const Class& one : list_) {
            if (tangent && *tangent >= one.from_tangent) {
                type = one.type;
            }
        }
        return type;
    }

private:
    struct Class {
        double from_tangent;
        std::uint8_t type;
    };
    std::vector<Class> list_;
};

/// Cells with the same fault: how many, and the first.
struct PolygonFaults {
    std::size_t count = 0;
    std::size_t first = 0;
    void add(std::size_t cell) { first = count++ == 0 ? cell : first; }
};

std::string in_words(const PolygonFaults& faults, const config::GridFrame& frame) {
    return counted(faults.count, "cell") + ", the first in " + cell_in_words(frame, faults.first);
}

std::string codes_in_words(const std::vector<rockfall::SurfaceType>& types) {
    std::string text;
    for (const rockfall::SurfaceType& type : types) {
        text += (text.empty() ? "" : ", ") + std::to_string(type.code);
    }
    return text;
}

/// Place of a code in the list of types; nothing if it has none.
std::optional<std::uint8_t> id_of(double code, const std::vector<rockfall::SurfaceType>& types) {
    const auto found = std::find_if(types.begin(), types.end(),
                                    [&](const rockfall::SurfaceType& type) { return type.code == code; });
    return found == types.end() ? std::nullopt
                                : std::optional{static_cast<std::uint8_t>(found - types.begin())};
}

/// A label without its form, as names of columns are compared.
std::string form_of_label(std::string_view label) {
    std::string form;
    for (const char c : config::plain_letters(label)) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
            form += c;
        }
    }
    return form;
}

/// The type of this label, else the only one whose label has the same letters and digits; null where there is
/// none.
const rockfall::SurfaceType* type_of_label(const std::string& label,
                                           const std::vector<rockfall::SurfaceType>& types) {
    const auto same = std::find_if(types.begin(), types.end(),
                                   [&](const rockfall::SurfaceType& type) { return type.label == label; });
    if (same != types.end()) {
        return &*same;
    }
    const std::string form = form_of_label(label);
    const auto is_like = [&](const rockfall::SurfaceType& type) { return form_of_label(type.label) == form; };
    if (form.empty() || std::count_if(types.begin(), types.end(), is_like) != 1) {
        return nullptr;
    }
    return &*std::find_if(types.begin(), types.end(), is_like);
}

/// The areas with the codes of their words; a problem for each word that is no label.
std::vector<config::CodedPolygon> coded_areas(const GroundCover& cover,
                                              const std::vector<rockfall::SurfaceType>& types,
                                              Reading& reading) {
    std::vector<config::CodedPolygon> areas = cover.areas;
    std::map<std::string, std::pair<config::Place, std::size_t>> unknown;
    for (const GroundWord& word : cover.words) {
        const rockfall::SurfaceType* const type = type_of_label(word.word, types);
        if (type != nullptr) {
            areas[word.area].code = type->code;
        } else {
            ++unknown.emplace(word.word, std::pair{word.place, std::size_t{0}}).first->second.second;
        }
    }
    std::string labels;
    for (const rockfall::SurfaceType& type : types) {
        labels += joined(labels.empty() ? "" : ", ", config::in_quotes(type.label));
    }
    for (const auto& [word, where] : unknown) {
        reading.refuse(where.first,
                       joined("ground ", config::in_quotes(word), " in ", counted(where.second, "area")),
                       joined("a code or a label of ", reading.shown(reading.terrain().surface_types),
                              types.empty() ? "" : ": ", labels),
                       "add a row with this label and a shipped ground type in the column like");
    }
    return areas;
}

/// A map of ground types without its areas beyond the terrain, which may have labels and codes of their own.
GroundCover cover_on_terrain(GroundCover cover, const config::GridFrame& frame, Reading& reading) {
    if (cover.areas.empty()) {
        return cover;
    }
    const std::string& setting = reading.terrain().surface_polygons;
    std::vector<std::string> names;
    for (const config::CodedPolygon& area : cover.areas) {
        names.push_back(std::isnan(area.code) ? "" : config::to_text(area.code));
    }
    for (const GroundWord& word : cover.words) {
        names[word.area] = word.word;
    }
    const plausible::Extent extent = plausible::extent_of(frame);
    const std::vector<std::size_t> stayed = plausible::take_out_areas_beyond(
        cover.areas, std::move(names),
        {{shown_tables(setting, reading)},
         "area",
         {},
         "areas of ground types on the terrain",
         "exchange x and y in the shapes",
         plausible::cut_command_of_first(reading, "surface_polygons", setting, extent)},
        extent, reading);
    std::vector<GroundWord> words;
    for (GroundWord& word : cover.words) {
        const auto place = std::lower_bound(stayed.begin(), stayed.end(), word.area);
        if (place != stayed.end() && *place == word.area) {
            word.area = static_cast<std::size_t>(place - stayed.begin());
            words.push_back(std::move(word));
        }
    }
    cover.words = std::move(words);
    return cover;
}

/// Cells that were holes of the heights have the ground of their neighbours where a grid has a hole, too.
config::Raster<double> codes_on(const HeightInput& heights, const GroundCover& cover,
                                const std::vector<rockfall::SurfaceType>& types, Reading& reading) {
    const config::GridFrame& frame = heights.frame();
    if (cover.grid) {
        config::Raster<double> codes = *cover.grid;
        if (!heights.filled_cells.empty()) {
            constexpr int most_cells = 100;  // as far as the largest hole that is filled reaches
            grids::take_nearest(codes, heights.filled_cells, most_cells);
        }
        return codes;
    }
    return config::rasterise_polygons(frame, coded_areas(cover, types, reading), no_code);
}

/// Outside its frame a map of ground types goes on as at its border, which nobody asked for.
bool covers_terrain(const config::GridFrame& frame, const std::string& file, const rockfall::Terrain& terrain,
                    Reading& reading) {
    for (const rockfall::Vertex& vertex : terrain.vertices()) {
        const double x_m = vertex.x_m + terrain.origin_m().x();
        const double y_m = vertex.y_m + terrain.origin_m().y();
        if (x_m < frame.x_west_m || x_m > frame.x_east_m() || y_m < frame.y_south_m ||
            y_m > frame.y_north_m()) {
            reading.refuse(
                {file},
                to_string(frame) + ", while the terrain reaches to " + config::place_in_words(x_m, y_m),
                "a grid over all of the terrain");
            return false;
        }
    }
    return true;
}

/// Ground types of faces that say their own, as cells for maps.
GroundMap ground_of_faces(const HeightInput& heights, const rockfall::Terrain& terrain,
                          const GroundCover& cover, std::vector<rockfall::SurfaceType> types,
                          Reading& reading) {
    if (cover.grid || !cover.areas.empty() || cover.by_slope || !reading.terrain().ground.empty()) {
        reading.note(heights.file +
                     ": its faces say their ground; other settings of where ground types lie have no effect");
    }
    GroundMap map{.types = std::move(types),
                  .ids = config::Raster<std::uint8_t>{heights.frame(), GroundMap::none}};
    const config::GridFrame& frame = map.ids.frame;
    for (std::size_t i = 0; i < map.ids.values.size(); ++i) {
        const config::Cell cell = frame.cell_of(i);
        const auto triangle = terrain.locate(frame.x_centre_m(cell.column) - terrain.origin_m().x(),
                                             frame.y_centre_m(cell.row) - terrain.origin_m().y());
        const std::uint32_t own = triangle ? terrain.triangles()[*triangle].surface : 0;
        if (own > 0) {
            map.ids.values[i] = static_cast<std::uint8_t>(own - 1);
        }
    }
    return map;
}

}  // namespace

std::optional<GroundCover> read_ground_cover(Reading& reading) {
    return reading.attempt([&] { return read_cover_and_classes(reading); });
}

bool check_frame(const config::GridFrame& frame, const std::string& file, const HeightInput& heights,
                 Reading& reading) {
    if (config::same_place(heights.frame(), frame)) {
        return true;
    }
    reading.refuse({file}, to_string(frame),
                   "the frame of " + heights.file + ", " + to_string(heights.frame()),
                   "resample it to the cells of that file (QGIS: Align rasters)");
    return false;
}

rockfall::SurfaceMap surface_map(const GroundMap& ground, const Eigen::Vector2d& origin_m) {
    config::GridFrame frame = ground.ids.frame;
    frame.x_west_m -= origin_m.x();
    frame.y_south_m -= origin_m.y();
    std::vector<std::uint8_t> ids = ground.ids.values;
    std::replace(ids.begin(), ids.end(), GroundMap::none, std::uint8_t{0});
    return {frame, std::move(ids)};
}

std::optional<GroundMap> match_ground(const HeightInput& heights, const rockfall::Terrain& terrain,
                                      const GroundCover& given, std::vector<rockfall::SurfaceType> types,
                                      Reading& reading) {
    if (heights.has_codes) {
        return ground_of_faces(heights, terrain, given, std::move(types), reading);
    }
    const std::size_t problems_before = reading.problems().list().size();
    const GroundCover cover = cover_on_terrain(given, heights.frame(), reading);
    if (cover.grid && (heights.grid ? !check_frame(cover.grid->frame, cover.file, heights, reading)
                                    : !covers_terrain(cover.grid->frame, cover.file, terrain, reading))) {
        return std::nullopt;
    }
    const config::Raster<double> codes = codes_on(heights, cover, types, reading);
    if (reading.problems().list().size() > problems_before) {
        return std::nullopt;
    }
    const auto ground = reading.attempt([&] { return uniform_ground(reading); });
    GroundNames names{types, ground.value_or(std::nullopt), *reading.settings().options};
    const auto classes = reading.attempt(
        [&] { return cover.by_slope ? SlopeClasses::read(*cover.by_slope, names) : SlopeClasses{}; });
    if (!classes) {
        return std::nullopt;
    }
    const std::optional<std::uint8_t> elsewhere = names.elsewhere();
    const auto id_without_code = [&](std::size_t cell) {
        const auto id = cover.by_slope ? classes->at(slope_tangent(heights, codes.frame, terrain, cell))
                                       : std::optional<std::uint8_t>{};
        return id ? id : elsewhere;
    };

    GroundMap map{.types = {}, .ids = config::Raster<std::uint8_t>{codes.frame, GroundMap::none}};
    std::map<double, PolygonFaults> unknown;
    PolygonFaults without;
    for (std::size_t cell = 0; cell < codes.values.size(); ++cell) {
        const double code = codes.values[cell];
        const auto id = std::isnan(code) ? id_without_code(cell) : id_of(code, types);
        if (!has_ground(heights, codes.frame, terrain, cell)) {
            // A mesh may reach into a cell whose centre lies beyond its border.
            map.ids.values[cell] = heights.grid ? GroundMap::none : id.value_or(GroundMap::none);
            continue;
        }
        if (id) {
            map.ids.values[cell] = *id;
        } else {
            (std::isnan(code) ? without : unknown[code]).add(cell);
        }
    }
    const std::string& file = cover.file.empty() ? heights.file : cover.file;
    for (const auto& [code, faults] : unknown) {
        reading.refuse(
            {file}, "surface code " + config::to_text(code) + " in " + in_words(faults, codes.frame),
            "a code of " + reading.shown(reading.terrain().surface_types) + ": " + codes_in_words(types),
            "add a row for this code, or correct the map");
    }
    if (without.count > 0) {
        reading.refuse({file}, "no surface code in " + in_words(without, codes.frame),
                       cover.by_slope
                           ? "a class of terrain.slope_grounds from 0 degrees on, or terrain.ground"
                           : "a code wherever the ground is known, or terrain.ground for the rest");
    }
    map.types = std::move(names).list();
    return unknown.empty() && without.count == 0 ? std::optional{std::move(map)} : std::nullopt;
}

}  // namespace coupling
