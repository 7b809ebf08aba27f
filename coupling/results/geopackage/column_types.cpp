#include "coupling/results/geopackage/column_types.hpp"

#include <algorithm>
#include <filesystem>

namespace coupling::geopackage {

bool is_key(std::string_view column) {
    return column == "name" || column == "regime" || column == "climate" || column.ends_with("_id");
}

std::vector<Column> declared_columns(const std::vector<std::string>& names,
                                     const std::vector<TableLayout>& layouts, const std::string& file) {
    const TableLayout* layout = find_layout(layouts, std::filesystem::path{file}.filename().string());
    std::vector<Column> columns;
    for (const std::string& name : names) {
        columns.push_back({name, ColumnType::text});
        if (layout == nullptr) {
            continue;
        }
        const auto found = std::find_if(layout->columns.begin(), layout->columns.end(),
                                        [&](const coupling::Column& column) { return column.name == name; });
        if (found != layout->columns.end()) {
            const ColumnType type = is_key(name) ? ColumnType::text : found->holds;
            columns.back() = {name, type, found->meaning, found->unit};
        }
    }
    return columns;
}

}  // namespace coupling::geopackage
