#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/disk/write_watch.hpp"
#include "coupling/results/geopackage/package.hpp"

namespace coupling::vectors {

/// Writes those layers of a GeoPackage that are for the field (geopackage::Plan) as results.gpx (GPX 1.1): a
/// point is a waypoint, a line or an area a track, areas round their outlines. Each feature has its columns
/// as a text with units, and as fields in the namespace that GDAL reads. Heights above sea are elevations.
///
/// `projection`: ESRI text of the map's system. The same layers give the same bytes. Throws
/// config::InputError (file), and what `watch` throws.
WrittenFile write_gpx(const std::filesystem::path& folder, geopackage::Database& database,
                      std::span<const geopackage::Written> layers, const std::string& projection,
                      const WriteWatch& watch);

}  // namespace coupling::vectors
