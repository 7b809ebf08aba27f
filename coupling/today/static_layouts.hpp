#pragma once

#include <vector>

#include "coupling/results/table_layout.hpp"

namespace coupling {

/// Every table of an assessment of today.
const std::vector<TableLayout>& static_layouts();

// Columns that tables of several kinds of runs share.

/// id and name of a target.
std::vector<Column> target_columns();
/// Which of the two slopes a row speaks of.
Column cover_column();

}  // namespace coupling
