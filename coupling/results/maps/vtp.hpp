#pragma once

#include <Eigen/Core>
#include <ostream>
#include <span>

#include "rockfall/ensemble.hpp"

namespace coupling {

/// Writes sampled paths as VTK poly data (.vtp, for ParaView): a line a path with `rock` and `cover` (0
/// forest, 1 bare), at each corner `energy_kj` and `height_m`. Absolute coordinates.
void write_vtp(std::ostream& out, std::span<const rockfall::PathRecord> paths,
               const Eigen::Vector2d& origin_m);

}  // namespace coupling
