#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace coupling::report {

/// Rows of a table of texts that the program holds, without the line of its columns. Every field stands in
/// quotes, which are doubled inside; blanks at its ends belong to it. Throws std::logic_error for another
/// form and for a row with more or fewer fields than the table has columns.
std::vector<std::vector<std::string>> rows_of_texts(std::string_view table);

}  // namespace coupling::report
