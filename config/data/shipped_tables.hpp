#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace config {

class Table;

/// Text of a shipped parameter table, such as "tree_resistance.csv", as it stood in config/data at build
/// time. Throws std::out_of_range for a name that is not shipped.
std::string_view shipped_table(std::string_view name);
/// The same, read.
Table read_shipped_table(std::string_view name);

/// Names of all shipped tables: every CSV file of config/data, in alphabetical order.
std::vector<std::string> shipped_table_names();

}  // namespace config
