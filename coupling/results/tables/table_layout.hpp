#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/inputs/tables/csv_row.hpp"

namespace coupling {

/// What the fields of a column are: words, whole numbers, or numbers with decimals.
enum class Holds : std::uint8_t { text, whole, number };

/// A column of a table of the results, declared once: the header of the file, its rows, the data dictionary
/// and `bannwald info tables` take it from here.
struct Column {
    std::string name;  ///< ends with its unit where it has one
    std::string unit;  ///< "-" for counts, numbers without unit and ids; "text" for words and names
    std::string meaning;
    std::string source;  ///< where the value comes from: simulated, an input file, a publication
    Holds holds = Holds::number;
};

/// The unit that the name of a column ends with, such as "m3/ha" of volume_m3pha; else "text" for words and
/// "-".
std::string unit_in(const Column& column);

/// A table of the results: its columns in the order of the file.
struct TableLayout {
    std::string file;  ///< in tables/; YEAR stands for a number: "trees_YEAR.csv"
    std::string row;   ///< what one row is
    std::vector<Column> columns;
};

/// Lists one after the other.
template <class List, class... Lists>
List together(List all, const Lists&... more) {
    (all.insert(all.end(), more.begin(), more.end()), ...);
    return all;
}

/// nullptr if no layout has this file name.
const TableLayout* find_layout(const std::vector<TableLayout>& layouts, std::string_view file);

/// The line with the names of the columns.
void write_header(std::ostream& out, const TableLayout& layout);

}  // namespace coupling
