#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/tables/decade_tables.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling::decades {

/// Why the protection at a target in a year differs between replicates: the chance of their forests and
/// years, or that of their rocks.
///
/// Law of total variance: the variance s2 between replicates is that of the forests plus the mean variance
/// that the rocks leave within one. Rocks: with N_0 rocks of a replicate that arrive over the bare slope,
/// N_f (b + c) / N_0^3 (delta method on the four-fold table, as in results/indicators); shares are those of
/// all replicates together, so that a replicate without arrivals counts too.
struct VarianceSplit {
    std::size_t replicates = 0;
    double between = 0.0;  ///< s2 of protection between replicates, percent points squared
    double rocks = 0.0;    ///< mean within a replicate, percent points squared
    double forest = 0.0;   ///< between - rocks, at least 0: less than what the rocks leave is none known
};

/// Nothing for fewer than two replicates in which rocks arrive over the bare slope.
std::optional<VarianceSplit> variance_split(const Names& names, std::span<const MemberYears> members,
                                            std::size_t course, std::uint32_t target, std::int32_t year);

TableLayout variance_split_layout();

/// Writes tables/variance_split.csv: every course, target and year with rocks.
std::vector<WrittenFile> write_variance_splits(const std::filesystem::path& folder, const Names& names,
                                               const Site& site, std::span<const MemberYears> members);

}  // namespace coupling::decades
