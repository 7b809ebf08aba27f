#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/table/schema.hpp"
#include "config/table/table.hpp"

namespace coupling {

/// As Table::require, and proposes columns by parts of their names: `baumbezeichnung_botanisch` for
/// `species`. Nothing is renamed. Adds a problem for each of `wanted` that is missing; true if none is.
/// `instead`: what else helps, by column.
bool require_columns(const config::Table& table, std::string_view role,
                     const std::vector<std::string>& wanted, config::Problems& problems,
                     const std::map<std::string, std::string>& instead = {});

/// As TableSchema::require, with these proposals and what the columns declare `instead`.
void require_columns(const config::Table& table, const config::TableSchema& schema,
                     config::Problems& problems);

}  // namespace coupling
