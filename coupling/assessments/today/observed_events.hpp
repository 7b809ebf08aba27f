#pragma once

#include <ostream>
#include <vector>

#include "coupling/inputs/observed/events.hpp"
#include "coupling/inputs/own_files/own_rows.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/figures/json.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling {

/// The arrivals of one slope as the rows of arrivals.csv have them. Throws config::InputError (file) for rows
/// that no run wrote.
std::vector<observed::SimulatedPassage> simulated_passages(OwnRows& arrivals, const Site& site,
                                                           rockfall::Cover cover);

/// tables/observed_events.csv: two rows a quantity.
void write_observed_events(std::ostream& out, const std::vector<observed::EventComparison>& comparisons);

Json json_observed_events(const std::vector<observed::EventComparison>& comparisons);

}  // namespace coupling
