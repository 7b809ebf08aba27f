#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "rockfall/motion/rolling.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace rockfall {

/// How a rock moves along a groove.
struct GrooveLaw {
    double friction;                           ///< coefficient [-]
    double mass_factor = rolling_mass_factor;  ///< 5/7: rolls, 1: slides
    bool slides = false;
};

/// The way out of a groove: the run along the steepest edge of the mesh that falls away from a place.
///
/// Where two faces meet in a groove a rock rests on both, although each alone would let it go, and can only
/// move along the edge between them. The run begins at rest, follows the edge to its lower end with the
/// acceleration of rolling, 5/7 g (sin c - mu cos c) with c the dip of the edge (1 for 5/7 where it slides),
/// and leads into a triangle beyond that end. Choice; no published law.
///
/// Nothing if no edge within `reach_m` (the rock's radius) falls away more steeply than the friction angle:
/// then the rock lies in a pit. `end` of the piece is `edge`.
std::optional<RollingPiece> run_along_groove(const Terrain& terrain, std::uint32_t triangle,
                                             const Eigen::Vector3d& position_m, double reach_m,
                                             const GrooveLaw& law);

}  // namespace rockfall
