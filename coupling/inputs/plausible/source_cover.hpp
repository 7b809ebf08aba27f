#pragma once

#include "coupling/inputs/release_input.hpp"

namespace coupling::plausible {

/// Holds the shapes of the sources against the terrain. Refuses, with the likely cause, shapes of which most
/// lie off it, zones of which most does, and single polygons that lie wholly off it; warns of polygons that
/// do so in part, with the share of their area. Zones of a file without the column `zone` are its rows, so
/// single points may lie off the terrain where most do not.
void judge_source_shapes(const SourceInput& input, const rockfall::Terrain& terrain, Reading& reading);

/// Warns of polygons on the terrain that hold the centre of no cell: no rock starts there. `cells` is how
/// many cells each shape has.
void doubt_polygons_without_cell(const SourceInput& input, const std::vector<std::size_t>& cells,
                                 Reading& reading);

}  // namespace coupling::plausible
