#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "coupling/results/csv_row.hpp"
#include "coupling/results/figures.hpp"
#include "coupling/results/table_layout.hpp"

namespace coupling {

// Columns that tables of all kinds of runs share; `add_…` fills them.

/// rocks, reached, share of them, and distributions of energy, speed and height.
std::vector<Column> arrival_columns();
void add_arrivals(CsvRow& row, const ArrivalFigures& arrivals);

/// Counts with and without forest, protection effect, indices of risk reduction.
std::vector<Column> protection_columns();
void add_protection(CsvRow& row, std::uint64_t rocks, const PairedCounts& paired,
                    const std::optional<ProtectionEffect>& effect,
                    const std::optional<RiskReduction>& reduction);

/// All rocks on a slope: how they stopped, run-out, largest values, hits.
std::vector<Column> slope_columns();
void add_slope(CsvRow& row, const SlopeFigures& slope);

}  // namespace coupling
