#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "coupling/results/out_file.hpp"
#include "coupling/results/run_results.hpp"

namespace coupling {

/// Writes the results of a run into an existing folder: rasters/, tables/, summary.json, report.html.
///
/// `streamed`: tables that were written while rocks fell, so that summary and report name them too. Returns
/// all files, one sentence each. A file that cannot be written, or a full disk, throws config::InputError
/// (file) naming it; what was written so far stays.
std::vector<WrittenFile> write_results(const RunResults& results, const std::filesystem::path& folder,
                                       std::span<const WrittenFile> streamed = {});

}  // namespace coupling
