#pragma once

#include <filesystem>
#include <vector>

#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/figures/run_results.hpp"

namespace coupling {

// One row an observation, the unit in the name of each column, UTF-8, comma, decimal point. Empty fields: not
// known, or too few rocks to know. README.md of this room describes every column.

void write_targets(std::ostream& out, const Figures& figures, const std::vector<Cover>& covers);
void write_protection(std::ostream& out, const Figures& figures);
void write_target_distributions(std::ostream& out, const RunResults& results);
void write_runs(std::ostream& out, const Figures& figures, const std::vector<Cover>& covers);
void write_run_out(std::ostream& out, const RunResults& results);
void write_tree_hits_per_rock(std::ostream& out, const RunResults& results);
void write_stems(std::ostream& out, const RunResults& results);
void write_logs(std::ostream& out, const RunResults& results);

/// Writes all of them and the sampled trajectories into tables/ of a folder.
std::vector<WrittenFile> write_tables(const RunResults& results, const Figures& figures,
                                      const std::filesystem::path& folder);

}  // namespace coupling
