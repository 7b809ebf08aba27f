#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coupling/results/geopackage/package.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling::geopackage {

/// Whether a column holds names or identifiers (`name`, `regime`, `climate`, all that end in `_id`): words,
/// whatever they look like, so that a key has the same type in every table.
bool is_key(std::string_view column);

/// The columns of a table with what its layout says that they hold. `file`: its path in the results. What no
/// layout has counts as words.
std::vector<Column> declared_columns(const std::vector<std::string>& names,
                                     const std::vector<TableLayout>& layouts, const std::string& file);

}  // namespace coupling::geopackage
