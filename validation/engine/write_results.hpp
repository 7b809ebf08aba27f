#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "coupling/results/disk/out_file.hpp"
#include "coupling/run/short_run.hpp"
#include "validation/engine/case/case_result.hpp"

namespace coupling::validation {

/// Names of all files that write_results() may write.
const std::vector<std::string>& result_names();

/// Writes report, summary and tables of cases and puts them in their place. The same results give the same
/// bytes. Returns the files. Throws InputError (file).
std::vector<WrittenFile> write_results(std::span<const CaseResult> cases, ShortRun& results);

}  // namespace coupling::validation
