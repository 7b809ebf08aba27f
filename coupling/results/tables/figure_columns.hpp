#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "coupling/inputs/tables/csv_row.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling {

// Columns that tables of all kinds of runs share; `add_…` fills them.

/// id and name of a target.
std::vector<Column> target_columns();
/// Which of the two slopes a row speaks of.
Column cover_column();

/// Rocks with more than each of rockfall::counted_energies_j: their number and, per 1000 released, with its
/// 95 % interval: above_30_kj_rocks, above_30_kj_per_1000, ...
std::vector<Column> energy_rate_columns();
void add_energy_rates(CsvRow& row, std::span<const Share> above);

/// rocks, reached, share of them, rocks above given energies, and distributions of energy,
/// speed and height.
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
