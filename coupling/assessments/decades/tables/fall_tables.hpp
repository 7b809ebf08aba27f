#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/tables/decade_tables.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/disk/write_watch.hpp"

namespace coupling::decades {

/// Writes tables/protection.csv, targets.csv and runs.csv: the figures of the static assessment, for every
/// regime, replicate and year with rocks; and causes.csv: the share of each cause that ends a fall. Throws
/// config::InputError (file).
std::vector<WrittenFile> write_fall_tables(const std::filesystem::path& folder, const Names& names,
                                           const Site& site, std::span<const MemberYears> members);
std::vector<TableLayout> fall_layouts();

/// Writes rasters/rockfall/REGIME/year_N/ and rasters/rockfall/bare/year_N/: the rocks of all replicates in a
/// chosen year, under the names of the static assessment. No percentiles.
std::vector<WrittenFile> write_fall_maps(const std::filesystem::path& folder, const Names& names,
                                         const Site& site, std::span<const MemberYears> members,
                                         const WriteWatch& watch = {});

}  // namespace coupling::decades
