#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/table/schema.hpp"
#include "config/table/table.hpp"

namespace coupling {

/// As Table::require, and proposes columns by parts of their names: `baumbezeichnung_botanisch` for
/// `species`. Nothing is renamed. Adds a problem for each of `wanted` that is missing; true if none is.
bool require_columns(const config::Table& table, std::string_view role,
                     const std::vector<std::string>& wanted, config::Problems& problems);

/// As TableSchema::require, with these proposals.
void require_columns(const config::Table& table, const config::TableSchema& schema,
                     config::Problems& problems);

}  // namespace coupling
