#pragma once

#include <string>
#include <vector>

#include "config/table/schema.hpp"
#include "coupling/inputs/reading/reading.hpp"

namespace coupling {

/// Throws where a table lacks columns; warns of those that are passed over but may stand for one that it
/// lacks.
void check_columns(const config::Table& table, const config::TableSchema& schema, Reading& reading);

/// The declared table that a setting names, with `check_columns`. `id_opening`: see Reading::table.
config::Table table_of(const config::TableSchema& schema, const std::string& name, Reading& reading,
                       const std::string& id_opening = "");

/// A file of a setting that may name several of them.
struct NamedTable {
    std::string name;        ///< as the setting has it
    std::string id_opening;  ///< for ids that are numbers: "road_" of road.shp; none of the only file
};
std::vector<NamedTable> tables_in(const std::string& value);

/// Such a setting in messages: its first file, and how many others.
std::string shown_tables(const std::string& value, const Reading& reading);

/// The rows of a table whose reader has no checks of its own.
template <class Row>
std::vector<config::Read<Row>> rows_of(const config::Schema<Row>& schema, const std::string& name,
                                       Reading& reading) {
    return schema.all(table_of(schema, name, reading));
}

}  // namespace coupling
