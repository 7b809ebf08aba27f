#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rockfall/terrain/tin.hpp"

namespace rockfall {

/// Side of a face: corner `side` to corner (side + 1) % 3.
struct TinSide {
    std::uint32_t face;
    std::uint32_t side;
};

/// Which faces meet at which edges.
struct TinEdges {
    /// Across each side: no_triangle at borders, and where more than two faces meet or two disagree on the
    /// sense of their corners.
    std::vector<std::array<std::uint32_t, 3>> neighbours;
    std::vector<TinSide> borders;                     ///< sides of one face alone
    std::vector<TinSide> crowded;                     ///< one side of each edge of more than two faces
    std::vector<std::array<TinSide, 2>> disagreeing;  ///< edges that two faces run along in the same sense
};

TinEdges edges_of(std::span<const TinFace> faces);

/// Faces whose corners run the other way round than those of most faces that they hang together with over
/// edges of two faces, rising. Where that leaves an edge of the same sense (a surface of one side alone, as a
/// strip of Moebius) a face at it too; of as many of either sense those against the first face. Empty only if
/// no edge disagrees.
std::vector<std::uint32_t> flipped_faces(const TinEdges& edges);

/// A number for each face, the same for all that hang together over edges, from 0 in order of the faces.
std::vector<std::uint32_t> parts_of(const TinEdges& edges);

}  // namespace rockfall
