#pragma once

#include <vector>

#include "validation/engine/case/comparison.hpp"
#include "validation/engine/years/result_tables.hpp"

namespace coupling::validation::years {

/// Tables and charts of the page, in the order of their queries; a query without rows gives none. Layers have
/// the same colours in all charts: the seven that the first one has most of, the others together are grey.
/// Rows of lines and dots that follow each other with the same plot, name and label make one series; its
/// label stands at its last point. `asked`: fields for captions.
void draw(ResultTables& tables, const std::vector<Query>& queries, const Fields& asked, Outcome& outcome);

}  // namespace coupling::validation::years
