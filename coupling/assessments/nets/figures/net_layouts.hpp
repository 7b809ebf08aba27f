#pragma once

#include <vector>

#include "coupling/results/tables/table_layout.hpp"

namespace coupling {

/// nets.csv, net_needs.csv and net_crossings.csv.
std::vector<TableLayout> net_layouts();

/// Those and net_inexact.csv: all that `bannwald net try` writes.
std::vector<TableLayout> net_try_layouts();

/// net_places.csv and the tables of stretches and candidates: all that `bannwald net place` writes.
std::vector<TableLayout> net_place_layouts();

/// What these commands write beside the tables of a run, for `bannwald info tables`.
const std::vector<TableLayout>& net_command_layouts();

}  // namespace coupling
