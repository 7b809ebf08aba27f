#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "coupling/inputs/scenario/output_settings.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/disk/write_watch.hpp"
#include "coupling/results/geopackage/results_package.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling {

/// Adds what GIS programs take to a folder of results, as far as wanted: results.gpkg, results.qlr, the
/// layers of the first in other formats (vectors/), a GeoTIFF beside each grid, trajectories.vtp, and
/// results.xlsx. `files`: all tables and rasters, the streamed ones among them; `layouts`: of the tables;
/// `paths`: the sampled ones. Returns what was added. Throws config::InputError (file), and what `watch`
/// throws.
std::vector<WrittenFile> write_gis_files(const std::filesystem::path& folder, const GisFiles& wanted,
                                         const Site& site, std::span<const WrittenFile> files,
                                         const std::vector<TableLayout>& layouts,
                                         const StreamedTables& streamed = {},
                                         std::span<const rockfall::PathRecord> paths = {},
                                         const WriteWatch& watch = {},
                                         std::span<const geopackage::AreaLayer> areas = {});

}  // namespace coupling
