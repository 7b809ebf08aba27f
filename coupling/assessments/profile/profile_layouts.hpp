#pragma once

#include <vector>

#include "coupling/results/tables/table_layout.hpp"

namespace coupling::profile {

/// Every table of a run along a profile.
const std::vector<TableLayout>& profile_layouts();

}  // namespace coupling::profile
