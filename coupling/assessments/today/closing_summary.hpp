#pragma once

#include <filesystem>
#include <vector>

#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/run_results.hpp"

namespace coupling {

/// The answer of the run in a few lines, and the files worth opening (all if `verbose`): results to stdout.
void print_summary(const RunResults& results, const std::filesystem::path& folder,
                   const std::vector<WrittenFile>& written, bool verbose);

}  // namespace coupling
