#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coupling/inputs/formats/layer.hpp"

namespace coupling::formats {

/// Whether bytes begin as a database of SQLite does, which a GeoPackage is.
bool is_database(std::string_view bytes);

/// What SQLite keeps beside a database while a program has it open, or had it when it broke off.
struct BesideDatabase {
    std::string_view log;      ///< its name with `-wal` behind it: committed changes; empty: none
    std::string_view journal;  ///< with `-journal`: what an unfinished change has to be undone with
};

/// A layer, and whether rows of it came from the write-ahead log.
struct PackageLayer {
    Layer layer;
    bool has_log = false;
};

/// Reads a layer, or a table without shapes, of a GeoPackage from its bytes and those of its write-ahead log,
/// so that it is what other programs show. `layer` may be empty where there is one only. Each row is a
/// feature; its place in messages is `feature number:column number`. The key of the table is a column like
/// any other.
///
/// Throws InputError naming what is wrong: no GeoPackage, no such layer (with those that are there), damaged
/// pages, a log that is damaged or of another database, an unfinished change, geometries that cannot be read,
/// more rows or text than a table of ours may have.
PackageLayer read_geopackage(std::string_view bytes, const std::string& layer, const std::string& file,
                             const BesideDatabase& beside = {});

/// The names of those layers of a GeoPackage that hold no row. Throws as `read_geopackage` does.
std::vector<std::string> empty_layers_of(std::string_view bytes, const std::string& file,
                                         const BesideDatabase& beside = {});

}  // namespace coupling::formats
