#include "coupling/results/tables/data_dictionary.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/results/maps/rasters.hpp"
#include "coupling/results/tables/table_of.hpp"

namespace coupling {
namespace {

using config::joined;

constexpr std::string_view tables_folder = "tables/";
constexpr std::string_view grid_ending = ".asc";
constexpr std::string_view all_years_folder = "all_years";

/// What the folder of a raster says about its values.
std::string_view words_of(std::string_view folder) {
    if (folder == "rasters/forest") {
        return "with forest";
    }
    if (folder == "rasters/bare") {
        return "on the bare slope";
    }
    if (folder == "rasters/difference") {
        return "with forest minus bare slope";
    }
    if (folder.starts_with("rasters/rockfall/")) {
        return folder.find("/bare/") == std::string_view::npos
                   ? "with forest, rocks of all replicates in year N"
                   : "on the bare slope, rocks of all replicates in year N";
    }
    return folder.ends_with(all_years_folder) ? "by patch, all years with rocks of all replicates"
                                              : "by patch in year N, mean of the replicates";
}

/// A column of a table, or a raster in a folder.
struct DictionaryRow {
    std::string where;  ///< the table, or the folder
    const Column& column;
    std::string meaning;
};

ColumnsOf<DictionaryRow> dictionary_columns(const Column& where, const Column& what, const char* unit,
                                            const char* meaning) {
    constexpr const char* defined = "definition";
    return {
        {where, &DictionaryRow::where},
        {what, [](const auto& row) { return row.column.name; }},
        {"unit", unit, defined, [](const auto& row) { return row.column.unit; }},
        {"meaning", meaning, defined, &DictionaryRow::meaning},
        {"source", "where the value comes from", defined, [](const auto& row) { return row.column.source; }}};
}

TableOf<DictionaryRow> column_table() {
    return {"data_dictionary.csv", "Every column of the tables: unit, meaning, source.",
            "a column of a table",
            dictionary_columns({"table", "text", "file in tables/", "definition"},
                               {"column", "text", "name of the column", "definition"},
                               "unit; - for counts, ids and ratios, text for words and names",
                               "what the value says")};
}

TableOf<DictionaryRow> raster_table() {
    return {"raster_dictionary.csv", "Every raster: unit, meaning, source.", "a raster in a folder",
            dictionary_columns(
                {"folder", "text",
                 "folder of the raster; REGIME, CLIMATE and year_N stand for those of the run", "definition"},
                {"raster", "text", "file name without ending", "definition"},
                "unit of the cells; NODATA is -9999", "what a cell says")};
}

void add_rasters(auto& rows, const DictionaryOfRun& declared, std::span<const WrittenFile> files) {
    std::set<std::pair<std::string, std::string>> done;
    for (const WrittenFile& file : files) {
        if (!file.path.ends_with(grid_ending)) {
            continue;
        }
        const std::string stem = std::filesystem::path{file.path}.stem().string();
        const std::string folder = folder_pattern(file.path);
        const auto column = std::find_if(declared.rasters.begin(), declared.rasters.end(),
                                         [&](const Column& c) { return c.name == stem; });
        if (column != declared.rasters.end() && done.emplace(folder, stem).second) {
            rows.add({folder, *column, joined(column->meaning, "; ", words_of(folder))});
        }
    }
}

}  // namespace

void write_dictionary(std::ostream& out, const std::vector<TableLayout>& tables, std::string_view folder,
                      std::span<const WrittenFile> files) {
    const auto add_columns = [&](auto& rows, const std::string& name) {
        const TableLayout* layout = find_layout(tables, name);
        layout = layout != nullptr ? layout : find_layout(dictionary_layouts(), name);
        for (std::size_t i = 0; layout != nullptr && i < layout->columns.size(); ++i) {
            rows.add({name, layout->columns[i], layout->columns[i].meaning});
        }
    };
    column_table().write_to(out, [&](auto& rows) {
        for (const WrittenFile& file : files) {
            if (file.path.starts_with(folder)) {
                add_columns(rows, file.path.substr(folder.size()));
            }
        }
    });
}

const std::vector<TableLayout>& dictionary_layouts() {
    static const std::vector<TableLayout> layouts{column_table(), raster_table()};
    return layouts;
}

std::vector<Column> raster_columns() {
    std::vector<Column> columns;
    std::vector<RasterKind> kinds = raster_kinds();
    kinds.push_back(repeats_kind());
    kinds.insert(kinds.end(), spread_kinds().begin(), spread_kinds().end());
    kinds.insert(kinds.end(), release_kinds().begin(), release_kinds().end());
    for (const RasterKind& kind : kinds) {
        columns.push_back({std::string{kind.stem}, std::string{kind.unit}, std::string{kind.meaning},
                           kind.percentile ? "simulated; bins, at most 3.2 % from the value" : "simulated"});
    }
    return columns;
}

std::string folder_pattern(const std::string& path) {
    const std::filesystem::path folder = std::filesystem::path{path}.parent_path();
    const std::string years = folder.filename().string();
    if (!years.starts_with("year_") && years != all_years_folder) {
        return folder.generic_string();
    }
    const std::filesystem::path slope = folder.parent_path();  // rasters/KIND/REGIME, perhaps with /CLIMATE
    if (slope == "rasters/rockfall/bare") {
        return (slope / "year_N").generic_string();
    }
    const bool has_climate = std::distance(slope.begin(), slope.end()) > 3;
    const std::filesystem::path kind = has_climate ? slope.parent_path().parent_path() : slope.parent_path();
    return (kind / (has_climate ? "REGIME/CLIMATE" : "REGIME") /
            (years == all_years_folder ? years : "year_N"))
        .generic_string();
}

void add_data_dictionary(const std::filesystem::path& folder, const DictionaryOfRun& declared,
                         std::vector<WrittenFile>& files) {
    const bool has_rasters = std::any_of(
        files.begin(), files.end(), [](const WrittenFile& file) { return file.path.ends_with(grid_ending); });
    if (has_rasters) {
        files.push_back(
            raster_table().write(folder, [&](auto& rows) { add_rasters(rows, declared, files); }));
    }
    files.push_back({joined(tables_folder, column_table().file), column_table().sentence});
    OutFile file{folder / files.back().path};
    write_dictionary(file.stream(), declared.tables, tables_folder, files);
    file.close();
}

}  // namespace coupling
