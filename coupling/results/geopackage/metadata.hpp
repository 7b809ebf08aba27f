#pragma once

#include <string>

#include "coupling/results/geopackage/package.hpp"

namespace coupling::geopackage {

// What a GeoPackage says about itself: OGC 12-128r17 (version 1.3), names and types of tables as the standard
// has them.

/// Marks a new database as GeoPackage and makes the tables that every one has. Requires an open transaction.
void create_metadata(Database& database, const SpatialReference& reference);

/// The form as the standard writes it, such as POINT.
const char* name_of(Form form);

/// Makes the empty R-tree of a layer.
std::string create_index(const std::string& layer);
std::string index_name(const std::string& layer);
/// The same without quotes.
std::string index_table(const std::string& layer);

/// Makes a filled layer or table known, with its extent; from then on triggers keep its index whole when
/// others edit it.
void register_layer(Database& database, const Written& layer, const SpatialReference& reference);

}  // namespace coupling::geopackage
