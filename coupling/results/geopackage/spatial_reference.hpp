#pragma once

#include <cstdint>
#include <string>

namespace coupling::geopackage {

/// What the coordinates of a layer mean.
struct SpatialReference {
    std::int32_t id = -1;  ///< number in the GeoPackage; -1: plane coordinates of a place nobody named
    std::string name = "Undefined Cartesian SRS";
    std::string organization = "NONE";
    std::int32_t organization_id = -1;
    std::string definition = "undefined";  ///< well-known text
};

/// Number of a reference of the user's own: the first that no authority of the standard takes.
inline constexpr std::int32_t own_reference = 100'000;

/// From the text of a .prj file (WKT 1 as ESRI writes it).
///
/// A text that ends with AUTHORITY["EPSG", "n"] is that reference; any other is a reference of its own,
/// defined by the text; an empty one is undefined. No table of projections is consulted: EPSG numbers are not
/// guessed.
SpatialReference spatial_reference(const std::string& projection);

}  // namespace coupling::geopackage
