#pragma once

#include <filesystem>
#include <span>

#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/geopackage/package.hpp"
#include "coupling/results/qgis/layer_tree.hpp"

namespace coupling::qgis {

/// The tree of a run's results: layers of results.gpkg on top, then the rasters in the groups of their
/// folders, then the tables.
///
/// Titles and legends are in the language in use (results/text/writing_language.hpp); tables and rasters keep
/// the names that they have in files. Rasters are drawn as the .qml beside them says. Trees over years come
/// by regime and year, of the first replicate. `files`: all results so far; `layers`: what results.gpkg in
/// the folder holds.
TreeGroup results_tree(const std::filesystem::path& folder, std::span<const WrittenFile> files,
                       std::span<const geopackage::Written> layers);

/// Writes results.qlr into the folder; `projection` is the text of the DEM's .prj. Throws config::InputError
/// (file).
WrittenFile write_results_tree(const std::filesystem::path& folder, const std::string& projection,
                               std::span<const WrittenFile> files,
                               std::span<const geopackage::Written> layers);

}  // namespace coupling::qgis
