#pragma once

#include <filesystem>
#include <vector>

#include "coupling/inputs/observed/events.hpp"
#include "coupling/inputs/own_files/own_rows.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/json.hpp"
#include "coupling/results/tables/table_layout.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling {

/// The arrivals of one slope as the rows of arrivals.csv have them. Throws config::InputError (file) for rows
/// that no run wrote.
std::vector<observed::SimulatedPassage> simulated_passages(OwnRows& arrivals, const Site& site,
                                                           rockfall::Cover cover);

/// Writes tables/observed_events.csv: two rows a quantity.
WrittenFile write_observed_events(const std::filesystem::path& folder,
                                  const std::vector<observed::EventComparison>& comparisons);
TableLayout observed_events_layout();

Json json_observed_events(const std::vector<observed::EventComparison>& comparisons);

}  // namespace coupling
