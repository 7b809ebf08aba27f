#pragma once

#include <string>
#include <vector>

#include "validation/engine/forest_cases/production_runs.hpp"

namespace coupling::validation::forest_cases {

/// Columns that a reference may have: those that find a row, and those of r3PG, compared or not.
std::vector<std::string> known_columns();

/// "; not read: bio_stem": the columns of its reference that are none of r3PG's; "" without.
std::string unread_columns(const ReferenceRun& run);

/// The columns of a reference with their figures, each with its row of our run. Requires `row_in_run`. Throws
/// InputError (data) for what is neither a number nor empty, and where nothing is left to compare.
std::vector<ComparedColumn> compared_columns(const ReferenceRun& run);

}  // namespace coupling::validation::forest_cases
