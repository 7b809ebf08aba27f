#pragma once

#include <cstddef>
#include <optional>

#include "coupling/inputs/release/release_input.hpp"

namespace coupling::plausible {

/// Holds the shapes of the sources against the terrain. Refuses, with the likely cause, shapes of which most
/// lie off it, zones of which most does, and single polygons that lie wholly off it; warns of polygons that
/// do so in part, with the share of their area. Zones of a file without the column `zone` are its rows, so
/// single points may lie off the terrain where most do not.
void judge_source_shapes(const SourceInput& input, const rockfall::Terrain& terrain, Reading& reading);

/// The later row that has the same polygon, if any.
std::optional<std::size_t> later_twin(const SourceInput& input, std::size_t number);

/// Warns of a polygon that lies under polygons of later rows, or is one of them: no rock starts from its row.
void warn_of_covered_polygon(const SourceInput& input, std::size_t number, Reading& reading);

}  // namespace coupling::plausible
