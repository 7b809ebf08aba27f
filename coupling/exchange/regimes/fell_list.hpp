#pragma once

#include <vector>

#include "config/errors/input_error.hpp"
#include "config/table/declared.hpp"
#include "config/table/table.hpp"
#include "coupling/exchange/regimes/intervention.hpp"
#include "coupling/exchange/regimes/run_years.hpp"

namespace coupling {

struct FelledTreeRow;
const config::Schema<FelledTreeRow>& felled_tree_columns();

/// The trees of a recorded cut: rows of tree_id (whole number, as in the list of trees) and year (of the run,
/// from 0, or a calendar year from 1500 on), by year and number. Other columns are read over.
///
/// Throws one InputError (data) for missing columns, an empty list, values that are no whole numbers, a tree
/// named twice, and a mixture of calendar years and years of the run.
std::vector<ListedTree> read_fell_list(const config::Table& table);

/// Turns its calendar years into years of the run. Adds a problem where a year lies before the start, and
/// where none is in the run; years after the end stay: the run ends before them.
void use_run_years(std::vector<ListedTree>& list, const std::string& file, const RunYears& run,
                   config::Problems& problems);

}  // namespace coupling
