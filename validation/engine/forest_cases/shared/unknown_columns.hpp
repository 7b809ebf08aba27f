#pragma once

#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "config/table/table.hpp"

namespace coupling::validation::forest_cases {

/// Adds a warning for each column of a table that nothing reads: a misspelt optional column would otherwise
/// be left out in silence. Names the nearest of the `known` columns that the table does not have.
///
/// Columns `note`, `remark`, `comment` and `source` are the user's own.
void warn_of_unknown_columns(const config::Table& table, const std::vector<std::string>& known,
                             config::Warnings& warnings);

}  // namespace coupling::validation::forest_cases
