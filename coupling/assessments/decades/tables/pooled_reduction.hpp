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
#include "coupling/results/figures/indicators.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling::decades {

/// Reduction of frequency, intensity and risk at a target in a year of a course, over the rocks of all
/// replicates together: one replicate has too few rocks for percentiles of energy.
struct PooledReduction {
    std::uint64_t arrivals_bare = 0;
    std::uint64_t arrivals_forest = 0;
    RiskReduction reduction;
    std::size_t replicates = 0;
    Interval orpi_90{};  ///< jackknife over replicates, Student's t; NaN where it is not known
};

/// Nothing where no rock arrives over the bare slope.
std::optional<PooledReduction> pooled_reduction(const Names& names, std::span<const MemberYears> members,
                                                std::size_t course, std::uint32_t target, std::int32_t year);

TableLayout pooled_reduction_layout();

/// Writes tables/risk_reduction.csv: every course, target and year with rocks.
std::vector<WrittenFile> write_pooled_reductions(const std::filesystem::path& folder, const Names& names,
                                                 const Site& site, std::span<const MemberYears> members);

}  // namespace coupling::decades
