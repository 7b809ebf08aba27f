#include "coupling/inputs/formats/geopackage_layer.hpp"

#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/formats/sqlite_log.hpp"
#include "coupling/inputs/formats/wkb.hpp"

namespace coupling::formats {
namespace {

using config::joined;

constexpr std::string_view magic{"SQLite format 3\0", 16};
constexpr const char* export_again = "export the layer again as GeoPackage (QGIS: Save features as)";

/// The database in memory. Nothing in it is believed: no functions of its schema run, and queries end.
class Package {
public:
    Package(std::string_view bytes, const BesideDatabase& beside, const std::string& file) : file_{file} {
        bytes = with_changes(bytes, beside);
        sqlite3* opened = nullptr;
        sqlite3_open_v2(":memory:", &opened, SQLITE_OPEN_READWRITE | SQLITE_OPEN_MEMORY, nullptr);
        database_.reset(opened);
        // A database that a program has open keeps new rows beside it; its header says so.
        constexpr std::size_t at_write_version = 18;
        if (bytes.size() > at_write_version + 1 &&
            (bytes[at_write_version] == 2 || bytes[at_write_version + 1] == 2)) {
            copy_ = copy_.empty() ? std::string{bytes} : std::move(copy_);
            copy_[at_write_version] = copy_[at_write_version + 1] = 1;
            bytes = copy_;
        }
        // The library takes the bytes as they are and only reads them.
        auto* const start = reinterpret_cast<unsigned char*>(const_cast<char*>(bytes.data()));
        const auto size = static_cast<sqlite3_int64>(bytes.size());
        check(sqlite3_deserialize(opened, "main", start, size, size, SQLITE_DESERIALIZE_READONLY));
        sqlite3_db_config(opened, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
        sqlite3_db_config(opened, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
        constexpr int longest_value_bytes = 64 << 20;
        sqlite3_limit(opened, SQLITE_LIMIT_LENGTH, longest_value_bytes);
        constexpr int steps = 10'000;
        sqlite3_progress_handler(opened, steps, &Package::is_enough, this);
        if (has_log_) {
            check_pages();
        }
    }

    /// Whether pages of the write-ahead log count.
    [[nodiscard]] bool has_log() const { return has_log_; }

    struct Close {
        void operator()(sqlite3* database) const { sqlite3_close(database); }
        void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
    };
    using Statement = std::unique_ptr<sqlite3_stmt, Close>;

    Statement prepare(const std::string& sql, const std::vector<std::string>& values = {}) {
        sqlite3_stmt* prepared = nullptr;
        check(sqlite3_prepare_v2(database_.get(), sql.c_str(), static_cast<int>(sql.size()), &prepared,
                                 nullptr));
        Statement statement{prepared};
        for (std::size_t i = 0; i < values.size(); ++i) {
            sqlite3_bind_text(prepared, static_cast<int>(i + 1), values[i].c_str(),
                              static_cast<int>(values[i].size()), SQLITE_TRANSIENT);
        }
        return statement;
    }

    bool step(const Statement& statement) {
        const int result = sqlite3_step(statement.get());
        if (result == SQLITE_ROW) {
            return true;
        }
        if (result != SQLITE_DONE) {
            check(result);
        }
        return false;
    }

    /// Whether the database has a table (no view) of a name.
    bool has_table(const std::string& name) {
        return step(prepare("SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = ?", {name}));
    }

    [[noreturn]] void refuse(std::string found, std::string expected, std::string advice) const {
        config::fail(config::ExitCode::data, {file_}, std::move(found), std::move(expected),
                     std::move(advice));
    }

private:
    /// The database as other programs show it.
    std::string_view with_changes(std::string_view bytes, const BesideDatabase& beside) {
        if (is_unfinished_journal(beside.journal)) {
            refuse("a rollback journal (-journal) with content beside it: a change is not finished",
                   "a GeoPackage that no program is writing to",
                   "save the layer and close it in other programs; after a crash open it there once");
        }
        if (beside.log.empty()) {
            return bytes;
        }
        try {
            copy_ = with_write_ahead_log(bytes, beside.log);
        } catch (const std::invalid_argument& error) {
            refuse_log(error.what());
        }
        has_log_ = copy_ != bytes;
        return copy_;
    }

    [[noreturn]] void refuse_log(const std::string& found) const {
        refuse(found, "the log of this GeoPackage, which holds its last changes",
               "close it in other programs, which folds the log in, and copy it again; delete the -wal only "
               "where it was left by another file of this name");
    }

    /// A log of another database of the same page size passes its checksums and gives pages that do not fit.
    void check_pages() {
        constexpr std::string_view of_structure = "*** in database";
        std::string found;
        try {
            const Statement pages = prepare("PRAGMA quick_check(1)");
            found = step(pages) ? reinterpret_cast<const char*>(sqlite3_column_text(pages.get(), 0)) : "";
        } catch (const config::InputError&) {
            found = of_structure;
        }
        if (found.starts_with(of_structure)) {  // what a table demands of its values is not looked at here
            refuse_log("a write-ahead log (-wal) beside it whose pages do not fit");
        }
    }

    void check(int result) const {
        if (result != SQLITE_OK) {
            refuse(joined("a damaged GeoPackage: ",
                          result == SQLITE_INTERRUPT ? "reading it takes no end" : sqlite3_errstr(result)),
                   "a complete GeoPackage", "copy the file again; close it in other programs first");
        }
    }

    /// Called again and again while a query runs.
    static int is_enough(void* package) {
        constexpr std::uint64_t most_calls = 50'000;  // 500 million steps: some hundred million values
        return ++static_cast<Package*>(package)->calls_ > most_calls ? 1 : 0;
    }

    const std::string& file_;
    std::string copy_;
    bool has_log_ = false;
    std::uint64_t calls_ = 0;
    std::unique_ptr<sqlite3, Close> database_;
};

std::string text_in(const Package::Statement& row, int column) {
    switch (sqlite3_column_type(row.get(), column)) {
        case SQLITE_INTEGER:
            return std::to_string(sqlite3_column_int64(row.get(), column));
        case SQLITE_FLOAT:
            return config::to_text(sqlite3_column_double(row.get(), column));
        case SQLITE_TEXT:
            return reinterpret_cast<const char*>(sqlite3_column_text(row.get(), column));
        default:
            return {};
    }
}

std::string_view blob_in(const Package::Statement& row, int column) {
    const void* bytes = sqlite3_column_blob(row.get(), column);
    const int size = sqlite3_column_bytes(row.get(), column);
    return bytes == nullptr
               ? std::string_view{}
               : std::string_view{static_cast<const char*>(bytes), static_cast<std::size_t>(size)};
}

/// The well-known binary in a geometry of a GeoPackage: behind a header with a box of one of four sizes.
std::string_view wkb_in(std::string_view blob) {
    constexpr std::size_t header_bytes = 8;
    constexpr std::array<std::size_t, 5> box_bytes{0, 32, 48, 48, 64};
    if (blob.size() < header_bytes || !blob.starts_with("GP")) {
        throw std::invalid_argument{"no geometry of a GeoPackage"};
    }
    const auto flags = static_cast<unsigned char>(blob[3]);
    const std::size_t box = (flags >> 1U) & 7U;
    if (box >= box_bytes.size() || (flags & 0x20U) != 0 || blob.size() < header_bytes + box_bytes[box]) {
        throw std::invalid_argument{"no geometry of a GeoPackage"};
    }
    return blob.substr(header_bytes + box_bytes[box]);
}

void check_contents(Package& package) {
    if (!package.has_table("gpkg_contents")) {
        package.refuse("a database without gpkg_contents", "a GeoPackage", export_again);
    }
}

std::string chosen_layer(Package& package, const std::string& wanted, const std::string& file) {
    check_contents(package);
    std::vector<std::string> names;
    std::vector<std::string> rasters;
    const auto contents = package.prepare("SELECT table_name, data_type FROM gpkg_contents");
    while (package.step(contents)) {
        const std::string kind = text_in(contents, 1);
        if (kind == "features" || kind == "attributes") {
            names.push_back(text_in(contents, 0));
        }
        if (kind == "tiles" || kind == "2d-gridded-coverage") {
            rasters.push_back(text_in(contents, 0));
        }
    }
    if (names.empty()) {
        package.refuse(rasters.empty() ? "a GeoPackage without layers" : "a GeoPackage of rasters only",
                       "a layer of features", "export rasters as GeoTIFF and layers as GeoPackage");
    }
    if (std::find(rasters.begin(), rasters.end(), wanted) != rasters.end()) {
        package.refuse(joined("layer ", config::in_quotes(wanted), ", which is a raster"),
                       "a layer of features",
                       "export it as GeoTIFF (QGIS: Save as) and name that where a grid is wanted");
    }
    if (wanted.empty() && names.size() == 1) {
        return names.front();
    }
    if (wanted.empty()) {
        package.refuse(joined(std::to_string(names.size()), " layers: ", listed(names)),
                       "the name of one of them", joined("write ", file, "|", names.front()));
    }
    if (std::find(names.begin(), names.end(), wanted) == names.end()) {
        package.refuse(joined("no layer ", config::in_quotes(wanted)), joined("one of ", listed(names)),
                       "correct the name behind |");
    }
    return wanted;
}

std::string quoted(const std::string& name) {
    std::string text = "\"";
    for (const char c : name) {
        text += c == '"' ? "\"\"" : std::string{c};
    }
    return text + '"';
}

std::string projection_of(Package& package, const std::string& system) {
    if (!package.has_table("gpkg_spatial_ref_sys")) {
        return {};
    }
    const auto row = package.prepare(
        "SELECT definition FROM gpkg_spatial_ref_sys WHERE srs_id = CAST(? AS INTEGER) AND srs_id > 0",
        {system});
    std::string text = package.step(row) ? text_in(row, 0) : std::string{};
    return text == "undefined" ? std::string{} : text;
}

}  // namespace

bool is_database(std::string_view bytes) {
    return bytes.starts_with(magic);
}

PackageLayer read_geopackage(std::string_view bytes, const std::string& layer, const std::string& file,
                             const BesideDatabase& beside) {
    Package package{bytes, beside, file};
    const std::string name = chosen_layer(package, layer, file);
    if (!package.has_table(name)) {
        package.refuse(joined("layer ", config::in_quotes(name), ", which is no table of this file"),
                       "a layer with rows of its own", export_again);
    }
    std::string shape_column;
    Layer read;
    if (package.has_table("gpkg_geometry_columns")) {
        const auto shapes = package.prepare(
            "SELECT column_name, srs_id FROM gpkg_geometry_columns WHERE table_name = ?", {name});
        if (package.step(shapes)) {
            shape_column = text_in(shapes, 0);
            read.projection = projection_of(package, text_in(shapes, 1));
        }
    }
    const auto rows = package.prepare("SELECT * FROM " + quoted(name));
    const int columns = sqlite3_column_count(rows.get());
    config::Features features{.file = file, .columns = {}, .cells = {}, .numbers = {}};
    int shapes_at = -1;
    for (int i = 0; i < columns; ++i) {
        const char* column = sqlite3_column_name(rows.get(), i);
        features.columns.emplace_back(column == nullptr ? "" : column);
        if (features.columns.back() == shape_column) {
            shapes_at = i;
            features.columns.back() = "wkt";
        }
    }
    config::Problems problems;
    constexpr std::size_t most_problems = 100;
    while (package.step(rows) && problems.list().size() < most_problems) {
        std::vector<std::string>& cells = features.cells.emplace_back();
        // GDAL and QGIS write the number of the feature first.
        features.numbers.push_back(sqlite3_column_type(rows.get(), 0) == SQLITE_INTEGER
                                       ? static_cast<std::uint32_t>(sqlite3_column_int64(rows.get(), 0))
                                       : static_cast<std::uint32_t>(features.cells.size()));
        for (int i = 0; i < columns; ++i) {
            if (i != shapes_at) {
                cells.push_back(text_in(rows, i));
                continue;
            }
            const std::string_view blob = blob_in(rows, i);
            cells.emplace_back();
            try {
                cells.back() = blob.empty() ? std::string{} : wkt_of_wkb(wkb_in(blob));
            } catch (const OtherKindOfShape& other) {
                problems.add(config::ExitCode::data,
                             {file, features.numbers.back(), static_cast<std::size_t>(i + 1)}, other.what(),
                             "points, lines or polygons", other.advice());
            } catch (const std::invalid_argument& error) {
                problems.add(config::ExitCode::data,
                             {file, features.numbers.back(), static_cast<std::size_t>(i + 1)}, error.what(),
                             "points, lines or polygons", export_again);
            }
        }
    }
    problems.throw_if_any();
    read.table = config::Table::of(std::move(features));
    return {std::move(read), package.has_log()};
}

std::vector<std::string> empty_layers_of(std::string_view bytes, const std::string& file,
                                         const BesideDatabase& beside) {
    Package package{bytes, beside, file};
    check_contents(package);
    std::vector<std::string> names;
    const auto contents = package.prepare("SELECT table_name FROM gpkg_contents");
    while (package.step(contents)) {
        const std::string name = text_in(contents, 0);
        if (package.has_table(name) &&
            !package.step(package.prepare(joined("SELECT 1 FROM ", quoted(name), " LIMIT 1")))) {
            names.push_back(name);
        }
    }
    return names;
}

}  // namespace coupling::formats
