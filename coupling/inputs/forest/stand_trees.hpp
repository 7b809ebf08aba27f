#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/grid/raster.hpp"
#include "coupling/inputs/places/records.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling {

/// The trees of a run without years whose forest is described by stands (stands.records, stands.dbh_classes):
/// those with which a run over years begins, from 5 cm DBH on and on the terrain, in absolute coordinates.
/// Heights that are missing come from the curve of another stand. Warns that places and single diameters are
/// derived. Nothing where something is wrong, which is reported.
std::optional<std::vector<TreeRecord>> trees_of_stands(const config::Raster<double>& heights_m,
                                                       const std::string& heights_file,
                                                       const rockfall::Terrain& terrain, Reading& reading);

}  // namespace coupling
