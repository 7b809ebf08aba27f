#pragma once

#include <string>

#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/systems/extent.hpp"

namespace coupling::plausible {

/// The command of GDAL that cuts a layer to the extent of the terrain, to the millimetre:
/// `ogr2ogr -clipsrc 1005 2005 1115 2095 road_cut.gpkg road.shp`. A layer in another system is transformed by
/// it as well. "" where one of the two systems is not known, or that of the terrain has no code: the numbers
/// of one system would then be taken for those of another. `name` is that of the setting, which may end in
/// `|layer`.
std::string cut_command(const Reading& reading, const std::string& role, const std::string& name,
                        const Extent& terrain);

/// The same of the first file of a setting that may name several.
std::string cut_command_of_first(const Reading& reading, const std::string& role, const std::string& setting,
                                 const Extent& terrain);

}  // namespace coupling::plausible
