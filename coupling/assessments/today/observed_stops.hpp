#pragma once

#include <filesystem>
#include <vector>

#include "coupling/inputs/observed/stops.hpp"
#include "coupling/inputs/own_files/own_rows.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/json.hpp"
#include "coupling/results/tables/table_layout.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling {

/// The ends of the rocks of one slope as the rows of rocks.csv have them. Throws config::InputError (file)
/// for rows that no run wrote.
std::vector<observed::SimulatedStop> simulated_stops(OwnRows& rocks, rockfall::Cover cover);

/// Observed stops beside those of the rocks of one slope. Empty without observed
/// stops.
std::vector<observed::StopComparison> compare_stops(const Site& site, rockfall::Cover cover,
                                                    const StreamedTables& streamed);

/// Writes tables/observed_stops.csv: two rows a group.
WrittenFile write_observed_stops(const std::filesystem::path& folder,
                                 const std::vector<observed::StopComparison>& comparisons);
TableLayout observed_stops_layout();

Json json_observed_stops(const std::vector<observed::StopComparison>& comparisons);

}  // namespace coupling
