#pragma once

#include <filesystem>
#include <vector>

#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/disk/write_watch.hpp"
#include "coupling/results/figures/run_results.hpp"
#include "coupling/results/gis_files.hpp"

namespace coupling {

/// Writes the results of a run into an existing folder: rasters/, tables/, results.gpkg, results.qlr,
/// summary.json, report.html.
///
/// `streamed`: tables that were written while rocks fell: summary and report name them too, and results.gpkg
/// holds them. Returns all files, one sentence each. A file that cannot be written, or a full disk, throws
/// config::InputError (file) naming it; what was written so far stays. `watch` may end the writing by
/// throwing.
std::vector<WrittenFile> write_results(const RunResults& results, const std::filesystem::path& folder,
                                       const StreamedTables& streamed = {}, const WriteWatch& watch = {});

}  // namespace coupling
