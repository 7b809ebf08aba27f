#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "config/errors/input_error.hpp"
#include "config/grid/raster.hpp"
#include "config/table/table.hpp"

namespace coupling {

/// Whether a table has a column and the row something in it.
bool has_value(const config::Table& table, std::size_t row, const std::string& column);

/// "220 x 241 cells of 5 m, corner 177198.3, 376897.5".
std::string to_string(const config::GridFrame& frame);

/// "row 3, column 17 (x 177203.3, y 376902.5)", counted from 1 at the north-western corner.
std::string cell_in_words(const config::GridFrame& frame, std::size_t index);

/// "1 cell", "5 cells".
std::string counted(std::size_t count, std::string_view singular);

/// Keeps the first 20 problems of a file and says how many more there are.
void add_first(config::Problems& problems, const config::Problems& of_file, const std::string& file);

}  // namespace coupling
