#pragma once

#include <string>
#include <string_view>

#include "coupling/inputs/formats/layer.hpp"

namespace coupling::formats {

/// Whether a text begins as an object of JSON.
bool is_geojson(std::string_view text);

/// Reads a FeatureCollection, or one Feature, of points, lines or polygons. The `crs` of the older
/// specification, as QGIS writes it, names the system; without it coordinates that can be degrees are WGS 84,
/// as the specification has it, and others are of a system that is not named. The place of a feature in
/// messages is its number.
///
/// Throws InputError (data) for what is no JSON (with line and column), no such collection, other kinds of
/// shapes.
Layer read_geojson(std::string_view text, const std::string& file);

}  // namespace coupling::formats
