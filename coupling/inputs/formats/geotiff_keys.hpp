#pragma once

#include <optional>
#include <string>

#include "coupling/inputs/formats/height_unit.hpp"

struct tiff;  // of libtiff

namespace coupling::formats {

/// What the keys of an open GeoTIFF say.
struct GeoKeys {
    bool cells_are_points = false;  ///< the tie point is the centre of a cell, not its corner
    std::string projection;         ///< well-known text of the system of plan coordinates, empty without one
    std::optional<HeightUnit> heights{};  ///< of the system of heights, or the unit that a key names
};

/// Reads the keys of GeoTIFF 1.0 and 1.1. A code of EPSG or ESRI, well-known text in a citation (as ArcGIS
/// and this program write it) and systems given by their parameters become well-known text. Of the
/// system of heights only unit and direction are read.
GeoKeys read_geo_keys(tiff* file);

}  // namespace coupling::formats
