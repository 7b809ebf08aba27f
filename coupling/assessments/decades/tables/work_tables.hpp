#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/tables/decade_tables.hpp"
#include "coupling/results/disk/out_file.hpp"

namespace coupling::decades {

/// Writes tables/interventions.csv, timber.csv, margins.csv where a regime did anything, and
/// removed_trees.csv where rocks killed trees. `area_ha`: of the forest. Throws config::InputError (file).
std::vector<WrittenFile> write_work_tables(const std::filesystem::path& folder, const Names& names,
                                           std::span<const MemberYears> members, double area_ha);
std::vector<TableLayout> work_layouts();

}  // namespace coupling::decades
