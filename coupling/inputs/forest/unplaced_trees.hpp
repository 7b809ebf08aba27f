#pragma once

#include "config/table/table.hpp"

namespace coupling {

/// Throws one InputError (data) for a list of trees that says nothing of where they stand, but which species
/// or size they have: trees that were counted, not mapped. Its message says how stands take them. Lists with
/// a coordinate, a shape, or a column that may be meant as one pass.
void refuse_unplaced_trees(const config::Table& trees);

}  // namespace coupling
