#pragma once

#include <string>

#include "config/geometry/shape.hpp"
#include "coupling/inputs/systems/extent.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling::plausible {

/// How much of a shape lies on the terrain.
struct OnTerrain {
    double size = 0.0;   ///< of all of it: area [m2] of polygons, length [m] of lines, number of points
    double share = 1.0;  ///< on the terrain [0, 1]
};

/// Samples that a side of a polygon's bounding box takes when a file has so many shapes: 150, so that shares
/// are good to about a hundredth, or 40 for more than a hundred shapes.
int samples_a_side(std::size_t shapes);

/// Sampled: polygons at `samples` x `samples` places of their bounding box, lines at 1000 places or more.
/// Shapes without area or length count by their vertices. Requires coordinates of the input and at least one
/// vertex.
OnTerrain on_terrain(const config::Shape& shape, const rockfall::Terrain& terrain, int samples = 150);

/// Whether any part of a shape lies on the terrain, whose extent is `extent`: also of a road of many
/// kilometres that crosses a corner of it, which `on_terrain` may miss. Lines and outlines are looked at
/// inside the extent at every thousandth of its diagonal. Requires coordinates of the input and at least one
/// vertex.
bool touches_terrain(const config::Shape& shape, const rockfall::Terrain& terrain, const Extent& extent);

/// "48 %"; shares that round to 0 or 100 % without being that as "less than 1 %" and "more than 99 %".
std::string percent_in_words(double share);

}  // namespace coupling::plausible
