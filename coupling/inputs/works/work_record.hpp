#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "coupling/inputs/nets/barrier_cost.hpp"

namespace coupling {

/// What stands beside nets against rocks.
enum class WorkKind : std::uint8_t {
    dam,      ///< heaped onto the ground
    ditch,    ///< dug into it
    wall,     ///< upright, holds what hits it up to a kinetic energy
    gallery,  ///< a roof over a road
};
inline constexpr std::size_t work_kinds = 4;

/// "dam", "ditch", "wall", "gallery".
const char* name_of(WorkKind kind);

/// Whether it is a part of the terrain.
constexpr bool is_of_earth(WorkKind kind) {
    return kind == WorkKind::dam || kind == WorkKind::ditch;
}

/// Sides of the outline of a dam or a ditch, in the order of its corners.
enum class WorkSide : std::uint8_t { uphill, far_end, downhill, near_end };
inline constexpr std::size_t work_sides = 4;

/// A work of the user's list, in coordinates of the terrain.
struct WorkRecord {
    std::string name;
    WorkKind kind = WorkKind::dam;
    double height_m = 0.0;           ///< of a dam or wall above the ground; depth of a ditch; 0: gallery
    double width_m = 0.0;            ///< of the crown of a dam or the floor of a ditch, in plan
    double uphill_face_deg = 0.0;    ///< of a dam or a ditch, from the horizontal
    double downhill_face_deg = 0.0;  ///< the same
    double capacity_j = std::numeric_limits<double>::infinity();  ///< of a wall or a roof
    BarrierCost cost{};
    std::vector<Eigen::Vector2d> line_m;     ///< as drawn: axis, or closed ring of a gallery
    std::vector<Eigen::Vector2d> outline_m;  ///< closed, on the ground, of all but walls
    /// At which rocks are counted: the outline, and above a dam or a ditch a strip as wide as it is high, in
    /// which rocks rest that it stopped [choice].
    std::vector<Eigen::Vector2d> counted_m;
    std::array<double, work_sides> side_ends_m{};  ///< of dams and ditches, along `counted_m`
    double volume_m3 = 0.0;                        ///< heaped or dug
    double ground_m2 = 0.0;                        ///< in plan
};

}  // namespace coupling
