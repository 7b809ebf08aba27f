#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "coupling/results/tables/table_layout.hpp"

namespace coupling {

/// A column of the table of ground types that some motion models use, whichever they are.
struct GroundColumn {
    const char* name;
    const char* unit;
    const char* meaning;
    int decimals = 2;                       ///< in grounds.csv
    double (*converted)(double) = nullptr;  ///< from the model's figure to the unit of the column
    const char* head = "";                  ///< on the page: a key of its texts
    int page_decimals = 2;                  ///< above 2: three digits, as the figure spans powers of ten
    double page_factor = 1.0;               ///< from the unit of the column to that of the page
    const char* repeats = "";  ///< column without which this one is shown on the page only where they differ
    const char* page_note = "";  ///< below the table where the column is shown: a key of the texts
};

/// The name of the column that holds text: the soil.
inline constexpr std::string_view soil_column = "soil";

/// All of them, in the order of the table. A motion model that uses a figure of another kind adds its column
/// here.
const std::vector<GroundColumn>& ground_columns();

/// The place of a column in that list. Throws std::logic_error for a name that is not there.
std::size_t ground_column(std::string_view name);

/// The same as columns of a table: the data dictionary says which motion models use each and where they take
/// it from.
std::vector<Column> ground_table_columns();

}  // namespace coupling
