#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/inputs/tables/csv_row.hpp"

namespace coupling {

/// A column of a table of the results, declared once: the header of the file, its rows, the data dictionary
/// and `bannwald info tables` take it from here.
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

/// The same. Throws std::logic_error if the table is not declared.
const TableLayout& layout_of(const std::vector<TableLayout>& layouts, std::string_view file);

/// The line with the names of the columns.
void write_header(std::ostream& out, const TableLayout& layout);

/// A declared table as it is written: first the line with the names of its columns, then rows. A row that has
/// not as many fields as the table has columns throws std::logic_error.
class TableRows : public CsvRow {
public:
    TableRows(std::ostream& out, const TableLayout& layout) : CsvRow{out, layout.columns.size()} {
        write_header(out, layout);
    }
    TableRows(std::ostream& out, const std::vector<TableLayout>& layouts, std::string_view file)
        : TableRows{out, layout_of(layouts, file)} {}
};

}  // namespace coupling
