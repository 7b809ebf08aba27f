#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "rockfall/virtual_surface/block_cover.hpp"

namespace coupling {

/// Side of the part of a surface that pictures show: 24 m, or all of a smaller one.
double shown_side_m(const rockfall::BlockCover& cover);

/// Blocks that reach into the shown part, from its south-western corner, lowest first. Those at its border
/// are there on both sides where the surface repeats itself.
std::vector<rockfall::Block> shown_blocks(const rockfall::BlockCover& cover);

/// A picture of a virtual surface to hold against the field: a square of it seen from above, blocks shaded
/// by their height over the ground, and a cut through it, with a scale bar and the outline of a rock of 0.95
/// m. `title` and `description` stand above it.
void write_surface_svg(const rockfall::BlockCover& cover, const std::string& title,
                       const std::string& description, std::ostream& out);

/// The same surface as triangles for CloudCompare, MeshLab or Blender: ASCII PLY with coloured vertices,
/// metres, z up. Blocks are spheres of few triangles, buried as they lie; the ground is one square.
void write_surface_ply(const rockfall::BlockCover& cover, std::ostream& out);

}  // namespace coupling
