#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "rockfall/rock_mass/placed_block.hpp"

namespace rockfall::rock_mass {

/// Most vertices of a block: what Euler's formula leaves to its faces [-].
constexpr std::size_t most_vertices = 2 * most_faces - 4;

/// How the vertices of a body lie to the faces of a foundation.
struct VertexSides {
    std::array<std::uint64_t, most_vertices> outside;  ///< by vertex: the faces it lies outside of, as bits
    std::uint16_t highest_face = 0;                    ///< the face that keeps the body farthest away
    std::uint16_t second_face = 0;                     ///< the next one
    double separation_m = -std::numeric_limits<double>::infinity();         ///< how far; below 0: it does not
    double second_separation_m = -std::numeric_limits<double>::infinity();  ///< of the next one
    std::uint64_t near = 0;  ///< faces that may be the nearest to a point of the body inside
};
static_assert(most_faces <= 64);

/// Inside, the nearest face is nowhere farther than the one that has the whole body closest to its outer
/// side. Ends early, without all of `outside`, at a face that separates the two.
void find_sides(const PlacedBlock& foundation, const PlacedBlock& body, VertexSides& sides);

/// A direction, from the first to the second of two blocks, along which they are apart.
struct SeparatingAxis {
    Eigen::Vector3d axis;  ///< unit
    double gap_m;          ///< along it
};

/// How far two blocks are apart along a unit vector from the first to the second; below 0 if they are not.
double apart_along_m(const Eigen::Vector3d& axis, const PlacedBlock& first, const PlacedBlock& second);

/// Looks for a direction that keeps two blocks apart, whatever their faces are, from a unit vector on; each
/// trial is mirrored at what it left between the two (Chung & Wang 1996, VRST, 125). What is found is exact,
/// but narrow gaps may be missed.
std::optional<SeparatingAxis> find_separating_axis(const Eigen::Vector3d& from, const PlacedBlock& first,
                                                   const PlacedBlock& second);

}  // namespace rockfall::rock_mass
