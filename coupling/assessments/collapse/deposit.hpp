#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "config/grid/raster.hpp"
#include "coupling/assessments/collapse/collapse_results.hpp"
#include "rockfall/solids/hull.hpp"

namespace coupling::collapse {

/// What lies in the cells of a map.
struct Deposit {
    std::vector<double> volume_m3;
    std::vector<double> largest_m;  ///< side of the cube of the largest block of which some part lies there

    explicit Deposit(std::size_t cells) : volume_m3(cells, 0.0), largest_m(cells, 0.0) {}
};

/// A block where it lies; coordinates of the map.
struct LyingBlock {
    const rockfall::solids::Hull& hull;  ///< about its centre, in principal axes
    Eigen::Vector3d centre_m;
    Eigen::Quaterniond attitude;
    double size_m;  ///< side of the cube of equal volume
};

/// Adds a block to the cells below and above which it lies, each with the part of its volume that does: the
/// integral of height over its faces, clipped to the cell, is exact. What lies beyond the map is lost.
void add_block(Deposit& deposit, const config::GridFrame& frame, const LyingBlock& block);

/// A block is part of the deposit if it lies farther from its start than its own size [-] [choice]: what
/// still stands on the cliff is none.
inline constexpr double moved_by_sizes = 1.0;

/// Where the blocks lie at the end that moved and did not leave the terrain.
Deposit deposit_of(const CollapseResults& results);

}  // namespace coupling::collapse
