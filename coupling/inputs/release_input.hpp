#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/geometry/shape.hpp"
#include "coupling/inputs/reading.hpp"
#include "coupling/inputs/terrain_input.hpp"
#include "rockfall/release/release.hpp"

namespace coupling {

/// Points, lines or polygons from which rocks break off.
struct SourceShape {
    std::uint32_t zone = 0;
    config::Shape shape;
};

/// Where rocks break off, as read: a grid of zones, or shapes all of one kind.
struct SourceInput {
    std::optional<config::Raster<double>> grid;
    std::vector<SourceShape> shapes;
    std::string file;  ///< name in messages
};

std::optional<SourceInput> read_sources(Reading& reading);

/// The sources on the terrain, in its coordinates, with their rocks allotted.
///
/// A cell weighs its true surface, plan area / cos(slope); a piece of a line its length; a point 1. Cells of
/// the outer ring, where the terrain ends halfway, and shapes off the terrain are left out and told. Refuses
/// sources on NODATA, a grid on another frame and sources of which none is left.
std::optional<std::vector<rockfall::ReleaseSource>> place_sources(const SourceInput& input,
                                                                  const HeightInput& heights,
                                                                  const rockfall::Terrain& terrain,
                                                                  Reading& reading);

}  // namespace coupling
