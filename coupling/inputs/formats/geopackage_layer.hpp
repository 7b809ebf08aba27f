#pragma once

#include <string>
#include <string_view>

#include "coupling/inputs/formats/layer.hpp"

namespace coupling::formats {

/// Whether bytes begin as a database of SQLite does, which a GeoPackage is.
bool is_database(std::string_view bytes);

/// Reads a layer, or a table without shapes, of a GeoPackage from its bytes. `layer` may be empty where there
/// is one only. Each row is a feature; its place in messages is `feature number:column number`. The key of
/// the table is a column like any other.
///
/// Throws InputError naming what is wrong: no GeoPackage, no such layer (with those that are there), damaged
/// pages, geometries that cannot be read, more rows or text than a table of ours may have.
Layer read_geopackage(std::string_view bytes, const std::string& layer, const std::string& file);

}  // namespace coupling::formats
