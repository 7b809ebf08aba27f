#pragma once

#include <filesystem>
#include <ostream>
#include <vector>

#include "coupling/inputs/site.hpp"
#include "coupling/observed/events.hpp"
#include "coupling/results/json.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling {

/// The arrivals of one slope as tables/arrivals.csv has them. Throws config::InputError (file) for a table
/// that cannot be read.
std::vector<observed::SimulatedPassage> simulated_passages(const std::filesystem::path& arrivals_csv,
                                                           const Site& site, rockfall::Cover cover);

/// tables/observed_events.csv: two rows a quantity.
void write_observed_events(std::ostream& out, const std::vector<observed::EventComparison>& comparisons);

Json json_observed_events(const std::vector<observed::EventComparison>& comparisons);

}  // namespace coupling
