#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/disk/write_watch.hpp"
#include "coupling/results/geopackage/package.hpp"

namespace coupling::vectors {

/// Writes the layers of a GeoPackage as results.kmz (OGC 12-007r2, KML 2.3, in a zip file): a folder for each
/// layer, shown as QGIS shows it, in the colours of the pages (energies by the classes of colours.hpp). A
/// feature has its columns as typed data, and as a text with units. Names and descriptions of folders are in
/// the language in use. Everything lies on the ground: heights
/// above sea stand in the coordinates, measures do not.
///
/// `projection`: ESRI text of the map's system. The same layers give the same bytes. Throws
/// config::InputError (file), and what `watch` throws.
WrittenFile write_kmz(const std::filesystem::path& folder, geopackage::Database& database,
                      std::span<const geopackage::Written> layers, const std::string& projection,
                      const WriteWatch& watch);

}  // namespace coupling::vectors
