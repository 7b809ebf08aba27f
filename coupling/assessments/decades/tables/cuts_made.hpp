#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/tables/decade_tables.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling::decades {

/// The ground on which a row of a regime has felled or girdled trees in a year, in the first replicate.
struct CutMade {
    std::size_t course = 0;  ///< regime and climate
    std::int32_t year = 0;
    std::size_t intervention = 0;          ///< row of the regime
    std::vector<forest::PatchId> patches;  ///< that lost a tree by it, each once
};

/// By course, year and row. Unlike the areas known before the run these are those where trees were cut: where
/// groups came to lie, where conditions held, where a thinning found something.
std::vector<CutMade> cuts_made(const Names& names, std::span<const MemberYears> members);

TableLayout cuts_made_layout();

/// Writes tables/cuts_made.csv with the outlines of patches as well-known text; nothing without a cut.
std::vector<WrittenFile> write_cuts_made(const std::filesystem::path& folder, const Names& names,
                                         const forest::PatchGrid& grid, std::span<const CutMade> cuts);

}  // namespace coupling::decades
