#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "coupling/results/figures/figures.hpp"

namespace coupling::report {

// Tables that compare arrivals with and without forest, row by row: along a line, by zone, by block size.

/// The headings: `first`, rocks without and with forest, what the forest stops, their energies.
std::vector<std::string> arrival_heads(const std::string& first, bool with_forest);

/// The cells of a row after its first one. `rocks`: how many fell.
void add_arrival_cells(std::vector<std::string>& cells, const rockfall::TargetTally& tally,
                       std::uint64_t rocks, bool with_forest);

}  // namespace coupling::report
