#pragma once

#include <string>
#include <vector>

#include "config/table/table.hpp"
#include "coupling/inputs/reading/reading.hpp"

namespace coupling::plausible {

/// Trees of a list that stand in it more than once, or no more on the slope.
struct RepeatedTrees {
    std::size_t again = 0;  ///< rows on the spot of an earlier one with the same tree_id (if there are such)
    std::size_t twice = 0;  ///< of them or of all on one spot, those with the same species and DBH
    std::string census;     ///< the column that distinguishes them: a year, a period; "" without one
    std::vector<std::string> censuses;  ///< what stands in it, sorted
    bool are_stems = false;             ///< a column numbers the stems of one tree instead
    std::string gone_column;  ///< a column that says which trees were removed or are dead; "" without one
    std::string gone_value;   ///< what stands there, the first
    std::size_t gone = 0;     ///< rows with such a value
};

/// Reads `x_m`, `y_m`, `species`, `dbh_cm`, `tree_id` where the table has it, and all columns that no reader
/// knows. A column distinguishes censuses if no two rows of one tree have the same value in it.
RepeatedTrees repeated_trees(const config::Table& table);

/// Errors where more than 5 % of the trees, and five or more [choice], are repeated or gone; a warning where
/// fewer are: rocks would meet all of them.
void judge_repeated_trees(const config::Table& table, Reading& reading);

}  // namespace coupling::plausible
