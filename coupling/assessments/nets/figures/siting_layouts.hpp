#pragma once

#include <vector>

#include "coupling/results/tables/table_layout.hpp"

namespace coupling::siting {

/// net_stretches.csv, net_candidates.csv, net_along.csv.
const std::vector<TableLayout>& siting_layouts();

}  // namespace coupling::siting
