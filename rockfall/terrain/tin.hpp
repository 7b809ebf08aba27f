#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "rockfall/terrain/terrain.hpp"

namespace rockfall {

/// A face of a given network: corners counter-clockwise seen from outside the ground.
struct TinFace {
    std::array<std::uint32_t, 3> corners{};
    std::uint32_t surface = 0;  ///< as in Triangle
};

/// Faces that somebody else made, with vertices in absolute coordinates [m].
struct Tin {
    std::vector<Eigen::Vector3d> vertices_m;
    std::vector<TinFace> faces;
};

/// What can be wrong with given faces. The first ones leave no terrain, `hole` and `parts` are only
/// suspicious.
enum class TinFault : std::uint8_t {
    no_area,     ///< three corners in one line
    doubled,     ///< the same three corners as another face
    crowded,     ///< an edge of more than two faces
    flipped,     ///< corners the other way round than those of its neighbour
    overhang,    ///< looks down: two heights over one place
    not_leaned,  ///< upright, and leaning it turns another face over
    overlap,     ///< a border over another face or border: parts over each other, or a seam not joined
    hole,        ///< a border around no ground
    parts,       ///< a part without connection to the largest one
};

constexpr bool is_doubt(TinFault fault) {
    return fault == TinFault::hole || fault == TinFault::parts;
}

/// Faults of one kind: how many, and where the first is.
struct TinFinding {
    TinFault fault;
    std::size_t count;
    Eigen::Vector3d place_m;  ///< middle of the face, edge or border
    std::size_t size = 0;     ///< of the first: edges of a hole, faces of a part
};

/// What was done to given faces before they became a terrain.
struct TinChanges {
    std::size_t joined = 0;       ///< vertices that lay exactly on another one
    std::size_t left_out = 0;     ///< faces two of whose corners are one vertex
    std::size_t leaned = 0;       ///< upright faces
    double largest_lean_m = 0.0;  ///< by which a vertex was moved in plan for it
    bool turned_over = false;     ///< all faces looked down
};

/// Given faces, checked, and how they became so.
struct CheckedTin {
    Tin tin;  ///< a terrain can be made of it if no finding is a fault
    std::vector<TinFinding> findings;
    TinChanges changes;

    [[nodiscard]] bool is_sound() const;
};

/// Upright faces lean by this much in plan from the foot of a wall to its top.
inline constexpr double upright_lean_m = 0.01;
/// Faces that lean by less than this count as upright, overhanging ones too: |n_z| / |n| [-].
inline constexpr double upright_tolerance = 1e-3;

/// Joins vertices at one place, leans upright faces and looks for faults (README.md). Requires finite
/// vertices and corners that exist.
CheckedTin checked(Tin tin);

/// The faces as they are, as a terrain. Requires a sound check.
Terrain terrain_of(const Tin& tin);

}  // namespace rockfall
