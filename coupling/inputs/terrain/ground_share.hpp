#pragma once

#include <string>

#include "coupling/inputs/terrain/terrain_input.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling::plausible {

/// How much of the area that known heights go round has ground.
struct GroundShare {
    double without_ground =
        0.0;               ///< share of the plan area inside the outline that no triangle covers [0, 1]
    double unknown = 0.0;  ///< share of the cells inside the outline without a height [0, 1]
    std::size_t unknown_cells = 0;  ///< how many these are
};

/// Of a grid, or of points by the cells of their mean spacing.
///
/// The outline goes round known cells and all gaps between them that are too narrow to be a border, and round
/// what these enclose (a lake). Too narrow is what the square of 2 n + 1 cells does not fit into, where n is
/// twice the mean distance of known cells as their nearest neighbours show it. So gaps count that hang
/// together with the rim, as those of a point cloud in too small cells do, and a valley cut along a crooked
/// border has none. The area inside is that of the triangles which a complete grid would have there.
GroundShare ground_share(const HeightInput& heights, const rockfall::Terrain& terrain);

/// Throws config::InputError (data) for a terrain without a triangle: why there is none, and what to do.
void refuse_terrain_without_faces(const HeightInput& heights, double longest_edge_m,
                                  const rockfall::Terrain& terrain);

/// Throws config::InputError (data) where all heights are one: contours or a grid without them.
void refuse_terrain_without_relief(const HeightInput& heights);

/// The gate of every terrain, whatever it was made of: faces, relief, and ground almost everywhere inside the
/// outline, of which a smaller part that lacks becomes a warning. `longest_edge_m` is that of the
/// triangulation.
void judge_ground(const HeightInput& heights, double longest_edge_m, const rockfall::Terrain& terrain,
                  Reading& reading);

}  // namespace coupling::plausible
