#include "coupling/inputs/formats/read_file.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/grid/ascii_grid.hpp"
#include "config/text/encoding.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/formats/column_names.hpp"
#include "coupling/inputs/formats/file_kinds.hpp"
#include "coupling/inputs/formats/geojson_layer.hpp"
#include "coupling/inputs/formats/geopackage_layer.hpp"
#include "coupling/inputs/formats/shapefile_layer.hpp"

namespace coupling::formats {
namespace {

using config::joined;

/// Endings that promise a form of bytes: files of that form have been read when they are looked at.
struct Ending {
    std::string_view ending;
    const char* found;
    const char* advice;
};

constexpr const char* no_tiff = "no TIFF behind this ending: it is cut off, damaged or of another kind";
constexpr std::array endings{
    Ending{".gpkg", "no GeoPackage behind this ending: it is encrypted, damaged or of another kind",
           "save it again without a password (QGIS: Save features as, GeoPackage)"},
    Ending{".tif", no_tiff, "copy or export the file again"},
    Ending{".tiff", no_tiff, "copy or export the file again"},
    Ending{".shp", "no Shapefile behind this ending: it is cut off, damaged or of another kind",
           "copy all files of that name again"}};

bool ends_as_geopackage(const std::string& file) {
    return config::in_lower_case(split_layer_name(file).file).ends_with(".gpkg");
}

void refuse_other_files(std::string_view bytes, const std::string& file, const char* expected) {
    refuse_other_file_kinds(bytes, file, expected);
    const std::string name = config::in_lower_case(split_layer_name(file).file);
    for (const Ending& promised : endings) {
        if (name.ends_with(promised.ending)) {
            config::fail(config::ExitCode::data, {file}, promised.found, expected, promised.advice);
        }
    }
    refuse_unknown_bytes(bytes, file, expected);
}

void refuse_mesh(std::string_view bytes, const std::string& file, const char* expected) {
    if (const FileKind* mesh = mesh_kind(bytes, file)) {
        config::fail(config::ExitCode::data, {file}, std::string{mesh->name}, expected,
                     advice_of(*mesh, file));
    }
}

constexpr const char* grid_expected = "a grid: GeoTIFF or ESRI ASCII";
constexpr const char* layer_expected = "a table or layer: CSV, GeoPackage, Shapefile or GeoJSON";

/// Text that begins with a brace and of no other kind that does.
bool is_geojson_of(std::string_view bytes, const std::string& file) {
    return is_geojson(bytes) && other_file_kind(bytes, file) == nullptr;
}

ShapefileParts parts_of_shapefile(std::string_view bytes, const std::string& file,
                                  const BytesBeside& beside) {
    const ShapefileParts parts{bytes, beside(".shx"), beside(".dbf"), beside(".prj"), beside(".cpg")};
    for (const auto& [part, ending] : {std::pair{parts.shx, ".shx"}, std::pair{parts.dbf, ".dbf"}}) {
        if (part.empty()) {
            config::fail(config::ExitCode::file, {file}, joined("no ", ending, " beside it"),
                         "a Shapefile with its .shx and .dbf", "copy all files of that name");
        }
    }
    return parts;
}

/// The first lines of a text, each with its end.
std::string_view first_lines(std::string_view text, std::size_t count) {
    std::size_t end = 0;
    for (; count > 0 && end < text.size(); --count) {
        end = std::min(text.find('\n', end), text.size() - 1) + 1;
    }
    return text.substr(0, end);
}

/// Whether a header names x, y and z of points, whatever else it names. A list of trees may have these, too.
bool names_points(std::string_view text) {
    constexpr std::size_t lines_looked_at = 4;
    constexpr std::size_t longest_bytes = 1U << 14U;
    text = first_lines(text, lines_looked_at);
    if (text.size() > longest_bytes || !config::is_utf8(text)) {
        return false;
    }
    try {
        config::Table table = config::Table::read(text, "", config::FirstColumn::may_lack_name);
        config::Table as_trees = table;
        static_cast<void>(name_columns(as_trees, "trees"));
        static_cast<void>(name_columns(table, "points"));
        if (as_trees.find("species") || as_trees.find("dbh_cm") || table.rows() == 0) {
            return false;
        }
        const auto are_numbers = [&](const char* column) {
            for (std::size_t row = 0; table.find(column) && row < table.rows(); ++row) {
                if (!config::parse_number(table.seen_text(row, column))) {
                    return false;
                }
            }
            return table.find(column).has_value();
        };
        return are_numbers("x_m") && are_numbers("y_m") && are_numbers("z_m");
    } catch (const config::InputError&) {
        return false;  // no table
    }
}

/// Rows of three or more numbers, perhaps below a line of names.
bool are_rows_of_numbers(std::string_view text) {
    constexpr std::size_t rows_looked_at = 3;
    constexpr std::size_t most_columns = 16;
    constexpr std::string_view separators = " \t,;\r";
    std::size_t rows = 0;
    std::size_t columns = 0;
    for (bool is_first = true; !text.empty() && rows < rows_looked_at; is_first = false) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        std::size_t numbers = 0;
        std::size_t words = 0;
        while (words <= most_columns) {
            line.remove_prefix(std::min(line.find_first_not_of(separators), line.size()));
            if (line.empty()) {
                break;
            }
            const std::size_t length = std::min(line.find_first_of(separators), line.size());
            numbers += config::parse_number(line.substr(0, length)) ? 1U : 0U;
            ++words;
            line.remove_prefix(length);
        }
        if (words == 0 || (is_first && numbers == 0)) {
            continue;  // a line of names
        }
        if (numbers < 3 || numbers != words || words > most_columns || (rows > 0 && words != columns)) {
            return false;
        }
        columns = words;
        ++rows;
    }
    return rows == rows_looked_at;
}

}  // namespace

bool is_list_of_points(std::string_view text) {
    text = config::without_byte_order_mark(text);
    return are_rows_of_numbers(text) || names_points(text);
}

std::string_view world_file_beside(const BytesBeside& beside) {
    for (const char* ending : {".tfw", ".tifw", ".tiffw", ".wld"}) {
        if (const std::string_view text = beside(ending); !text.empty()) {
            return text;
        }
    }
    return {};
}

bool is_gis_raster(std::string_view bytes) {
    return is_tiff(bytes);
}

bool is_gis_layer(std::string_view bytes) {
    return is_database(bytes) || is_shapefile(bytes) || is_geojson(bytes);
}

std::string format_in_words(std::string_view bytes) {
    return is_tiff(bytes)        ? "GeoTIFF"
           : is_database(bytes)  ? "layer of a GeoPackage"
           : is_shapefile(bytes) ? "Shapefile"
           : is_geojson(bytes)   ? "GeoJSON"
                                 : "CSV table";
}

PlacedGrid read_grid_file(std::string_view bytes, const std::string& file, const BytesBeside& beside) {
    if (is_tiff(bytes)) {
        PlacedGrid grid = read_geotiff(bytes, file, world_file_beside(beside));
        if (grid.projection.empty()) {
            grid.projection = std::string{config::trimmed(beside(".prj"))};
        }
        return grid;
    }
    if (is_database(bytes)) {
        config::fail(
            config::ExitCode::data, {file}, "a GeoPackage", grid_expected,
            "export its raster as GeoTIFF (QGIS: Save as; gdal_translate IN dem.tif); name polygons in "
            "the setting for polygons or shapes");
    }
    if (is_shapefile(bytes) || is_geojson_of(bytes, file)) {
        config::fail(config::ExitCode::data, {file}, joined("a ", format_in_words(bytes)), grid_expected,
                     "name polygons in the setting for polygons or shapes, or turn them into a grid (QGIS: "
                     "Rasterize)");
    }
    if (!config::most_grid_bytes(bytes)) {
        refuse_other_files(bytes, file, grid_expected);
        refuse_mesh(bytes, file, grid_expected);
        if (is_list_of_points(bytes)) {
            config::fail(config::ExitCode::data, {file}, "a list of points (x y z)", grid_expected,
                         "name it as terrain.points instead");
        }
    }
    config::AsciiGrid read = config::read_ascii_grid_with_words(bytes, file);
    PlacedGrid grid{std::move(read.raster), std::string{beside(".prj")}, {}};
    if (read.words.cells > 0) {
        grid.remarks.push_back(joined(read.words.cells == 1
                                          ? std::string{"1 cell"}
                                          : joined(std::to_string(read.words.cells), " cells"),
                                      " with a word such as ", config::in_quotes(read.words.first),
                                      " in place of a number, taken as NODATA"));
    }
    return grid;
}

ReadLayer read_layer_file(std::string_view bytes, const std::string& layer, const std::string& file,
                          const BytesBeside& beside) {
    if (is_database(bytes)) {
        PackageLayer read = read_geopackage(bytes, layer, file, {beside("-wal"), beside("-journal")});
        return {std::move(read.layer), true,
                read.has_log ? "read with the changes of the write-ahead log (-wal) beside it" : ""};
    }
    if (bytes.empty() || ends_as_geopackage(file)) {
        refuse_other_files(bytes, file, layer_expected);
    }
    if (!layer.empty()) {
        config::fail(config::ExitCode::data, {file},
                     joined("a layer name ", config::in_quotes(layer), " behind a file without layers"),
                     "a GeoPackage", "leave out | and what follows");
    }
    if (is_shapefile(bytes)) {
        refuse_other_file_kinds(bytes, file, layer_expected);  // its index begins as it does
        return {read_shapefile(parts_of_shapefile(bytes, file, beside), file), true, ""};
    }
    if (is_geojson_of(bytes, file)) {
        return {read_geojson(bytes, file), true, ""};
    }
    if (is_tiff(bytes) || config::most_grid_bytes(bytes)) {
        config::fail(config::ExitCode::data, {file},
                     is_tiff(bytes) ? "a raster (TIFF)" : "a raster (ESRI ASCII grid)", layer_expected,
                     "name grids in the setting for grids, or make areas of their cells (QGIS: Polygonize)");
    }
    refuse_other_files(bytes, file, layer_expected);
    refuse_mesh(bytes, file, layer_expected);
    if (is_utf16(bytes) || config::is_utf8(bytes)) {
        return {{config::Table::read(bytes, file, config::FirstColumn::may_lack_name), ""}, false, ""};
    }
    const std::string text = config::to_utf8(bytes, config::Encoding::windows_1252);
    return {{config::Table::read(std::string_view{text}, file, config::FirstColumn::may_lack_name), ""},
            false,
            "no UTF-8: its letters are taken as Windows-1252"};
}

void refuse_what_is_no_text_of_points(std::string_view bytes, const std::string& file) {
    constexpr const char* points_expected = "points as text: x y z in metres";
    if (is_tiff(bytes) || config::most_grid_bytes(bytes)) {
        config::fail(config::ExitCode::data, {file},
                     is_tiff(bytes) ? "a raster (TIFF)" : "a raster (ESRI ASCII grid)", points_expected,
                     "name it as terrain.dem instead");
    }
    refuse_other_file_kinds(bytes, file, points_expected);
    if (is_gis_layer(bytes)) {
        config::fail(config::ExitCode::data, {file}, joined("a ", format_in_words(bytes)), points_expected,
                     "name contours or points of a layer as terrain.mesh, with the ending of the format");
    }
    refuse_other_files(bytes, file, points_expected);
}

}  // namespace coupling::formats
