#pragma once

#include <filesystem>
#include <vector>

#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling {

/// intervals.csv and parameter_draws.csv of a run that drew what is not known; nothing without.
std::vector<WrittenFile> write_drawn(const RunResults& results, const Figures& figures,
                                     const std::filesystem::path& folder);

std::vector<TableLayout> drawn_layouts();

}  // namespace coupling
