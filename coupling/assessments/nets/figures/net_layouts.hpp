#pragma once

#include <vector>

#include "coupling/results/tables/table_layout.hpp"

namespace coupling {

/// nets.csv, net_needs.csv and net_crossings.csv.
std::vector<TableLayout> net_layouts();

/// net_inexact.csv, which `bannwald net try` writes beside them.
std::vector<TableLayout> net_try_layouts();

/// net_places.csv, which `bannwald net place` writes.
std::vector<TableLayout> net_place_layouts();

/// Both, for `bannwald info tables`.
const std::vector<TableLayout>& net_command_layouts();

}  // namespace coupling
