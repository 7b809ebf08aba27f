#pragma once

#include <string>

#include "config/grid/raster.hpp"
#include "coupling/inputs/reading/reading.hpp"

namespace coupling {

/// With output.kml or output.gpx the results are written in longitude and latitude, too: a terrain whose
/// system is not known, or from which PROJ has no way there, becomes a problem of the setting before any work
/// begins. Otherwise a note says how accurate the way is. `file`: that of the heights.
void check_degrees(const std::string& projection, const config::GridFrame& map, const std::string& file,
                   Reading& reading);

}  // namespace coupling
