#pragma once

#include <filesystem>
#include <vector>

#include "coupling/assessments/collapse/collapse_results.hpp"

namespace coupling::collapse {

/// Tables over time and of targets that are areas.
std::vector<TableLayout> series_layouts();

/// Writes block_series.csv, mean_block.csv and, where some target is an area, collapse_buildings.csv and
/// collapse_walls.csv into the folder tables of `folder`.
void write_series_tables(const CollapseResults& results, const std::filesystem::path& folder,
                         const WriteWatch& watch, std::vector<WrittenFile>& files);

}  // namespace coupling::collapse
