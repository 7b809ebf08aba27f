#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace coupling {

/// A column of a table of the results, declared once: the header of the file, the data dictionary and
/// `bannwald info tables` take it from here.
struct Column {
    std::string name;  ///< ends with its unit where it has one
    std::string unit;  ///< "-" for counts, numbers without unit and ids; "text" for words and names
    std::string meaning;
    std::string source;  ///< where the value comes from: simulated, an input file, a publication
};

/// A table of the results: its columns in the order of the file.
struct TableLayout {
    std::string file;  ///< in tables/; YEAR stands for a number: "trees_YEAR.csv"
    std::string row;   ///< what one row is
    std::vector<Column> columns;
};

/// Columns of groups one after the other.
template <class... Groups>
std::vector<Column> together(const Groups&... groups) {
    std::vector<Column> columns;
    (columns.insert(columns.end(), groups.begin(), groups.end()), ...);
    return columns;
}

/// nullptr if no layout has this file name.
const TableLayout* find_layout(const std::vector<TableLayout>& layouts, std::string_view file);

/// The line with the names of the columns. Throws std::logic_error if the table is not declared.
void write_header(std::ostream& out, const std::vector<TableLayout>& layouts, std::string_view file);

}  // namespace coupling
