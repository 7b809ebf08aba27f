#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/disk/write_watch.hpp"
#include "coupling/results/geopackage/package.hpp"

namespace coupling::vectors {

/// Writes the layers of a GeoPackage as ESRI Shapefiles into shapefiles/ of a folder, as the "ESRI Shapefile
/// Technical Description" (July 1998) has them: .shp, .shx, .dbf, .cpg (UTF-8), and .prj where the system is
/// known. Features of one Shapefile are of one kind: a layer of several becomes LAYER_points, LAYER_lines and
/// LAYER_areas. Outer rings go clockwise, holes the other way.
///
/// shapefiles/fields.csv has a row for each field: which column it is, its unit and meaning, and whether
/// words were cut at 254 bytes, which are all that a field takes. A layer that needs 2 GB or more is left out
/// and has a row that says so.
///
/// The same layers give the same bytes: the date in the tables is fixed. `projection`: ESRI text, empty
/// without a known system. Throws config::InputError (file), and what `watch` throws.
WrittenFile write_shapefiles(const std::filesystem::path& folder, geopackage::Database& database,
                             std::span<const geopackage::Written> layers, const std::string& projection,
                             const WriteWatch& watch);

}  // namespace coupling::vectors
