#pragma once

#include <filesystem>
#include <vector>

#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/figures/run_results.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling {

/// Every table of an assessment of today. One row an observation, the unit in the name of each column, UTF-8,
/// comma, decimal point. Empty fields: not known, or too few rocks to know.
const std::vector<TableLayout>& static_layouts();

/// Writes those that are written once all rocks have fallen, and the sampled trajectories, into tables/ of a
/// folder.
std::vector<WrittenFile> write_tables(const RunResults& results, const Figures& figures,
                                      const std::filesystem::path& folder);

}  // namespace coupling
