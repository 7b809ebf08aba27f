#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "coupling/results/figures/figures.hpp"
#include "coupling/results/tables/table_of.hpp"

namespace coupling {

// Columns that tables of all kinds of runs share.

/// Where numbers of rocks come from, as columns say it.
inline constexpr const char* from_counting = "counted over the simulated rocks";

struct TargetName {
    std::string_view id;
    std::string_view name;
};
/// id and name of a target.
ColumnsOf<TargetName> target_columns();
Column target_id_column();
/// Which of the two slopes a row speaks of.
Column cover_column();
Column rock_column();
/// Absolute easting, northing and height of a place to the centimetre: x_start_m, ... with the infix
/// "_start".
ColumnsOf<Eigen::Vector3d> place_columns(const std::string& infix, const std::string& of_what);

/// A share with its 95 % interval: reached_percent, reached_low_percent, reached_high_percent.
ColumnsOf<Share> share_columns(const std::string& name, const char* meaning);

/// Rocks from each of rockfall::counted_energies_j on: their number and, per 1000 released, with its
/// 95 % interval: above_30_kj_rocks, above_30_kj_per_1000, ...
using RocksAbove = decltype(ArrivalFigures::above);
ColumnsOf<RocksAbove> energy_rate_columns();

/// rocks, reached, share of them, rocks above given energies, and distributions of energy,
/// speed and height.
ColumnsOf<ArrivalFigures> arrival_columns();

/// How a rock fell, from its path to its impacts on the ground.
ColumnsOf<rockfall::RockRecord> motion_columns();

struct ProtectionFigures {
    std::uint64_t rocks = 0;
    PairedCounts paired;
    std::optional<ProtectionEffect> effect;
    std::optional<RiskReduction> reduction;
};
/// The protection effect with its interval.
ColumnsOf<ProtectionEffect> protection_effect_columns();
/// Counts with and without forest, protection effect, indices of risk reduction.
ColumnsOf<ProtectionFigures> protection_columns();

/// All rocks on a slope: how they stopped, run-out, largest values, hits.
ColumnsOf<SlopeFigures> slope_columns();

}  // namespace coupling
