#pragma once

#include <string>
#include <vector>

#include "config/table/schema.hpp"
#include "coupling/inputs/reading/reading.hpp"

namespace coupling {

/// Throws where a table lacks columns; warns of those that are passed over but may stand for one that it
/// lacks.
void check_columns(const config::Table& table, const config::TableSchema& schema, Reading& reading);

/// The declared table that a setting names, with `check_columns`.
config::Table table_of(const config::TableSchema& schema, const std::string& name, Reading& reading);

/// The rows of a table whose reader has no checks of its own.
template <class Row>
std::vector<config::Read<Row>> rows_of(const config::Schema<Row>& schema, const std::string& name,
                                       Reading& reading) {
    return schema.all(table_of(schema, name, reading));
}

}  // namespace coupling
