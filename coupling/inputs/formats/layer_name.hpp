#pragma once

#include <string>

namespace coupling::formats {

/// A file and a layer in it, as users and QGIS write it: `roads.gpkg`, `map.gpkg|roads`,
/// `map.gpkg|layername=roads`, `road.shp|layername=road`. Throws InputError (settings) for what else QGIS may
/// write behind the name, such as `|subset=...` or `|layerid=2`: it would be dropped.
struct LayerName {
    std::string file;
    std::string layer;
};
LayerName split_layer_name(const std::string& name);

}  // namespace coupling::formats
