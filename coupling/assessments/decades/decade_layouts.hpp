#pragma once

#include <vector>

#include "coupling/results/tables/table_layout.hpp"

namespace coupling::decades {

/// Every table of a run over years.
const std::vector<TableLayout>& decade_layouts();

}  // namespace coupling::decades
