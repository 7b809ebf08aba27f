#include "coupling/program/actions/info.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "config/data/shipped_tables.hpp"
#include "config/table/table.hpp"
#include "config/text/coordinates.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "coupling/exchange/regimes/listing.hpp"
#include "coupling/exchange/regimes/shipped.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/files_beside.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/formats/read_file.hpp"
#include "coupling/inputs/grids/raw_grid.hpp"
#include "coupling/inputs/grids/tile_names.hpp"
#include "coupling/inputs/grids/tiles.hpp"
#include "coupling/inputs/grids/vrt.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/terrain/mesh_input.hpp"
#include "coupling/program/actions/given_files.hpp"
#include "coupling/program/actions/info_tables.hpp"
#include "coupling/program/actions/input_tables.hpp"

namespace coupling {

namespace {

namespace fs = std::filesystem;

/// A grid begins with one of the keys of its header.
bool looks_like_grid(std::string_view text) {
    text = config::without_byte_order_mark(text);
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    const std::string word = config::in_lower_case(text.substr(0, text.find_first_of(" \t\r\n")));
    const std::set<std::string> keys{"ncols",     "nrows",    "xllcorner", "xllcenter", "yllcorner",
                                     "yllcenter", "cellsize", "dx",        "dy"};
    return keys.contains(word);
}

/// The name that a projection gives itself, else how its text begins.
std::string projection_in_words(const std::string& text) {
    const std::string beginning = text.substr(0, 200);
    const std::size_t first = beginning.find('"');
    const std::size_t last = first == std::string::npos ? first : beginning.find('"', first + 1);
    return last == std::string::npos ? beginning.substr(0, beginning.find('\n'))
                                     : beginning.substr(first + 1, last - first - 1);
}

/// The values of a grid of few different whole numbers, such as codes or zones.
void write_codes(const config::Raster<double>& grid, std::ostream& out) {
    std::map<double, std::size_t> counts;
    for (const double value : grid.values) {
        if (!std::isnan(value)) {
            ++counts[value];
        }
        if (counts.size() > 12) {
            return;
        }
    }
    out << "values      ";
    for (const auto& [value, count] : counts) {
        out << "  " << config::to_text(value) << ": " << counted(count, "cell");
    }
    out << '\n';
}

void write_grid(const formats::PlacedGrid& placed, const std::string& format, const std::string& prj,
                std::ostream& out) {
    const config::Raster<double>& grid = placed.raster;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    double sum = 0.0;
    std::size_t known = 0;
    for (const double value : grid.values) {
        if (!std::isnan(value)) {
            low = std::min(low, value);
            high = std::max(high, value);
            sum += value;
            ++known;
        }
    }
    const auto all = static_cast<double>(grid.values.size());
    out << format << '\n'
        << "frame         " << to_string(grid.frame) << '\n'
        << "extent        x " << config::metres_in_words(grid.frame.x_west_m) << " to "
        << config::metres_in_words(grid.frame.x_east_m()) << ", y "
        << config::metres_in_words(grid.frame.y_south_m) << " to "
        << config::metres_in_words(grid.frame.y_north_m()) << '\n'
        << "projection    "
        << (placed.projection.empty() ? "none (no " + prj + ")" : projection_in_words(placed.projection))
        << '\n'
        << "NODATA        " << std::fixed << std::setprecision(2)
        << 100.0 * (all - static_cast<double>(known)) / all << " % of the cells\n";
    if (known > 0) {
        out << "range         " << config::to_text(low) << " to " << config::to_text(high) << ", mean "
            << config::to_text(static_cast<float>(sum / static_cast<double>(known))) << '\n';
        write_codes(grid, out);
    }
}

/// What a grid of several files, or of one with a header beside it, is called; "" for any other file.
std::string kind_of_tiles(const std::string& name, std::string_view bytes) {
    return grids::is_virtual_raster(bytes)  ? "virtual raster (VRT)"
           : grids::is_list_of_tiles(bytes) ? "list of tiles"
           : grids::is_raw_grid(name)       ? "numbers with a header (.hdr)"
                                            : "";
}

/// A grid as a run lays it together, and what there is to say about that.
void write_tiles(const std::string& name, const std::string& kind, std::ostream& out) {
    HeightFiles files;
    grids::ReadGrid read =
        grids::read_grid({name}, {}, grids::GridValues::codes, std::nullopt, files.files());
    write_grid({std::move(read.raster), std::move(read.projection), {}}, kind, ".prj beside it", out);
    for (const std::string& note : read.notes) {
        out << "note          " << note << '\n';
    }
    for (const config::Problem& warning : read.warnings) {
        out << "warning       " << to_string(warning) << '\n';
    }
}

/// Range of a column of numbers, or how many different texts it holds.
std::string column_in_words(const config::Table& table, const std::string& column) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    bool all_numbers = table.rows() > 0;
    std::set<std::string> texts;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string& text = table.text(row, column);
        texts.insert(text);
        if (const auto value = config::parse_number(text)) {
            low = std::min(low, *value);
            high = std::max(high, *value);
        } else {
            all_numbers = false;
        }
    }
    return all_numbers ? config::to_text(low) + " to " + config::to_text(high)
                       : counted(texts.size(), "different text") +
                             (texts.empty() ? "" : ", such as " + config::in_quotes(*texts.rbegin()));
}

void write_table(const formats::Layer& layer, const std::string& format, std::ostream& out) {
    const config::Table& table = layer.table;
    out << format << "\nrows          " << table.rows() << '\n';
    if (!layer.projection.empty()) {
        out << "projection    " << projection_in_words(layer.projection) << '\n';
    }
    for (std::size_t i = 0; i < table.columns().size(); ++i) {
        const std::string& column = table.columns()[i];
        out << "column        " << std::left << std::setw(20) << column << ' ';
        if (!table.units().empty() && table.units()[i] != "unit" && table.units()[i] != "-") {
            out << '[' << table.units()[i] << "] ";
        }
        out << column_in_words(table, column) << '\n';
    }
}

/// The shipped table or regime of a name, with or without its ending.
std::optional<std::string_view> shipped(const std::string& name) {
    for (const std::string& table : config::shipped_table_names()) {
        if (name == table || name + ".csv" == table) {
            return config::shipped_table(table);
        }
    }
    for (const std::string& regime : shipped_regime_names()) {
        if (name == regime || name == regime + ".csv") {
            return shipped_regime(regime);
        }
    }
    return std::nullopt;
}

}  // namespace

void write_info(const std::string& name, const std::string& table, std::ostream& out) {
    if (!path_exists(name)) {
        if (name == "tables") {
            write_result_tables(table, out);
            return;
        }
        if (name == "inputs") {
            write_input_tables(table, out);
            return;
        }
        if (name == "regimes") {
            write_regime_listing(out);
            return;
        }
        if (const auto text = shipped(name)) {
            out << *text;
            return;
        }
    }
    if (is_folder(name)) {
        write_tiles(name, "folder of tiles", out);
        return;
    }
    const formats::LayerName wanted = formats::split_layer_name(name);
    const FileBytes bytes =
        open_file(wanted.file, {}, "a grid, a mesh, a table or the name of a shipped table");
    if (const std::string kind = kind_of_tiles(wanted.file, bytes.text()); !kind.empty()) {
        write_tiles(name, kind, out);
        return;
    }
    FilesBeside beside{wanted.file};
    if (formats::is_gis_raster(bytes.text()) || looks_like_grid(bytes.text())) {
        write_grid(formats::read_grid_file(bytes.text(), name, beside.bytes()),
                   formats::is_gis_raster(bytes.text()) ? "GeoTIFF" : "ESRI ASCII grid",
                   beside.path(".prj").filename().string(), out);
        return;
    }
    if (formats::is_gis_layer(bytes.text())) {
        write_table(formats::read_layer_file(bytes.text(), wanted.layer, name, beside.bytes()).layer,
                    formats::format_in_words(bytes.text()), out);
        return;
    }
    const meshes::MeshFormat format = meshes::format_of(bytes.text(), name);
    if (format != meshes::MeshFormat::points && format != meshes::MeshFormat::contours) {
        meshes::describe(meshes::read_mesh_file(bytes.text(), name), out);
        return;
    }
    write_table(formats::read_layer_file(bytes.text(), wanted.layer, name, beside.bytes()).layer, "CSV table",
                out);
}

}  // namespace coupling
