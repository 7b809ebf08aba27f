#pragma once

#include <vector>

#include "coupling/results/tables/table_layout.hpp"

namespace coupling {

/// Every table of an assessment of today.
const std::vector<TableLayout>& static_layouts();

}  // namespace coupling
