#pragma once

#include <cstdint>

#include "rockfall/motion/rolling.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace rockfall {

/// When a piece leaves its triangle in plan, and over which edge; infinite if it never does.
struct Leaving {
    double time_s;
    int edge;
};

Leaving leaving(const Terrain& terrain, std::uint32_t triangle, const RollingPiece& piece);

/// Ends a piece at the edge over which it leaves, if it leaves before its end; a piece that would be shorter
/// than `shortest_rolling_piece_s` runs over the edge a little, but not over a cliff or a wall.
void end_at_edge(RollingPiece& piece, const Terrain& terrain, std::uint32_t triangle, const Plane& plane,
                 const Leaving& out);

}  // namespace rockfall
