#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <span>

#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/tables/table_layout.hpp"
#include "rockfall/tally/impact_log.hpp"

namespace coupling {

/// Writes tables/impacts.csv: one row an impact of a rock whose path is kept. `origin_m` is added to
/// coordinates.
WrittenFile write_impacts(const std::filesystem::path& folder, std::span<const rockfall::RockImpacts> rocks,
                          const Eigen::Vector2d& origin_m);
TableLayout impact_layout();

}  // namespace coupling
