#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "rockfall/terrain/tin.hpp"

namespace rockfall {

/// A face that was left out because another one lies over it.
struct CoveredFace {
    std::size_t number = 0;  ///< in the list of given faces, from 0
    std::array<Eigen::Vector3d, 3> corners_m{};
};

/// What of given faces is seen from above.
struct UpperSurface {
    Tin tin;  ///< not yet checked
    std::vector<CoveredFace> left_out;
    std::size_t filled = 0;  ///< new faces between those that stayed
};

/// Keeps the uppermost of faces that lie over each other in plan, such as those of overhanging walls.
///
/// Of two faces whose plans overlap, the one that is lower over the middle of the overlap is left out as a
/// whole; of two at one height the later one. Which way faces look plays no part. The gaps that this leaves
/// are triangulated in plan (constrained Delaunay, the edges of the faces that stayed) between these and the
/// vertices of left-out faces over which nothing lies: a step leads from the rim of an overhang down to the
/// first ground that is seen from above. Nothing is filled where no given face lies. Upright faces lean first
/// (upright.hpp). Each face carries the ground of the uppermost given face over its middle. Requires finite
/// vertices and corners that exist.
///
/// Limits: the ground below an overhang is lost, and rocks that fall over its rim meet a steep step instead.
UpperSurface upper_surface(const Tin& given);

}  // namespace rockfall
