#pragma once

#include <string>

struct tiff;  // of libtiff

namespace coupling::formats {

/// What the keys of an open GeoTIFF say.
struct GeoKeys {
    bool cells_are_points = false;  ///< the tie point is the centre of a cell, not its corner
    std::string projection;         ///< well-known text of the system of plan coordinates, empty without one
};

/// Reads the keys of GeoTIFF 1.0 and 1.1. A code of EPSG or ESRI, well-known text in a citation (as ArcGIS
/// and this program write it) and systems given by their parameters become well-known text; the system of
/// heights is passed over.
GeoKeys read_geo_keys(tiff* file);

}  // namespace coupling::formats
