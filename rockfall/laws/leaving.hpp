#pragma once

#include <cstdint>

#include "rockfall/laws/rolling.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace rockfall {

/// When a piece leaves its triangle in plan, and over which edge; infinite if it never does.
struct Leaving {
    double time_s;
    int edge;
};

Leaving leaving(const Terrain& terrain, std::uint32_t triangle, const RollingPiece& piece);

/// The same where it leaves before its end; of one that does not, whenever or never.
Leaving leaving_in_time(const Terrain& terrain, std::uint32_t triangle, const RollingPiece& piece);

/// Ends a piece at the edge over which it leaves, if it leaves before its end.
void end_at_edge(RollingPiece& piece, const Terrain& terrain, std::uint32_t triangle, const Leaving& out);

/// The same, but a piece that would be shorter than `shortest_rolling_piece_s` runs over the edge a little,
/// if not over a cliff or a wall.
void end_near_edge(RollingPiece& piece, const Terrain& terrain, std::uint32_t triangle, const Plane& plane,
                   const Leaving& out);

/// The triangle into which a piece leads that ended over an edge; a short piece may have run on a little, and
/// then the walk finds it. `no_triangle` beyond the border.
std::uint32_t triangle_beyond(const Terrain& terrain, const RollingPiece& piece);

/// The centimetre after a run that ended in a vertex, at its last velocity: clear of the vertex the walk
/// finds the triangle. Requires a run that moves at its end.
RollingPiece centimetre_on(const RollingPiece& run);

}  // namespace rockfall
