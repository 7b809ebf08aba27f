#pragma once

#include <cstdint>

#include "coupling/results/figures/figures.hpp"
#include "coupling/results/templates/page_template.hpp"

namespace coupling::report {

/// A row of a table that compares arrivals with and without forest, along a line, by zone or by block size:
/// the fields of arrival_cells.html. `rocks`: how many fell.
PageFields arrival_cells(const rockfall::TargetTally& tally, std::uint64_t rocks);

}  // namespace coupling::report
