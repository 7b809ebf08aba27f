#pragma once

#include <filesystem>
#include <ostream>
#include <vector>

#include "coupling/inputs/site.hpp"
#include "coupling/observed/stops.hpp"
#include "coupling/results/json.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling {

/// The ends of the rocks of one slope as tables/rocks.csv has them. Throws config::InputError (file) for a
/// table that cannot be read.
std::vector<observed::SimulatedStop> simulated_stops(const std::filesystem::path& rocks_csv,
                                                     rockfall::Cover cover);

/// Observed stops beside those of the rocks of one slope. `rows` is the folder of the finished rocks.csv.
/// Empty without observed stops.
std::vector<observed::StopComparison> compare_stops(const Site& site, rockfall::Cover cover,
                                                    const std::filesystem::path& rows);

/// tables/observed_stops.csv: two rows a group.
void write_observed_stops(std::ostream& out, const std::vector<observed::StopComparison>& comparisons);

Json json_observed_stops(const std::vector<observed::StopComparison>& comparisons);

}  // namespace coupling
