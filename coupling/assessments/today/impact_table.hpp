#pragma once

#include <Eigen/Core>
#include <ostream>
#include <span>

#include "rockfall/tally/impact_log.hpp"

namespace coupling {

/// tables/impacts.csv: one row an impact of a rock whose path is kept. `origin_m` is added to coordinates.
void write_impacts(std::ostream& out, std::span<const rockfall::RockImpacts> rocks,
                   const Eigen::Vector2d& origin_m);

}  // namespace coupling
