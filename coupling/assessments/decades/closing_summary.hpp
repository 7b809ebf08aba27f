#pragma once

#include <filesystem>
#include <vector>

#include "coupling/assessments/decades/decade_results.hpp"

namespace coupling::decades {

/// The answer of the run in a few lines, and the files worth opening: results to stdout.
void print_summary(const DecadeResults& results, const std::filesystem::path& folder,
                   const std::vector<WrittenFile>& files, bool verbose);

}  // namespace coupling::decades
