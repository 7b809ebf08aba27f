#pragma once

#include <filesystem>
#include <vector>

#include "coupling/inputs/own_files/own_rows.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/breakdown.hpp"
#include "coupling/results/figures/run_results.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling {

/// Arrivals by place along lines, by release zone and by block size, read from the rows of arrivals.csv that
/// this run wrote: they are too many to keep. Released rocks are counted as they start. Throws
/// config::InputError (file) for rows that no run wrote.
Breakdown breakdown_of(OwnRows& arrivals, const Scenario& scenario, const Site& site);

/// The same from the streamed tables; unknown without targets or with output.arrivals = no.
Breakdown breakdown_of(const StreamedTables& streamed, const Scenario& scenario, const Site& site);

/// Writes along_lines.csv, by_zone.csv and by_size.csv, a row a stretch, zone or size, target and slope,
/// those that have rows, and adds them to `written`.
void write_breakdown(const RunResults& results, const std::filesystem::path& folder,
                     std::vector<WrittenFile>& written);
std::vector<TableLayout> breakdown_layouts();

}  // namespace coupling
