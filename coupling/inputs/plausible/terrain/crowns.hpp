#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "config/grid/raster.hpp"
#include "coupling/inputs/plausible/terrain/finding.hpp"

namespace coupling::plausible::terrain {

/// A listed tree on the grid of the heights.
struct ListedTree {
    double x_m = 0.0;
    double y_m = 0.0;
    double height_m = 0.0;
};

/// How far the ground stands up at the trees.
struct Bumps {
    std::size_t trees = 0;      ///< of 8 m and more, with known heights around
    double median_m = 0.0;      ///< height at the stem less the mean around it
    double median_share = 0.0;  ///< of the height of the tree [-]
};

/// Around: eight places at 5 m or two cells, whichever is more, so that an even slope has none.
Bumps bumps_at(const config::Raster<double>& heights, std::span<const ListedTree> trees);

/// A surface model, where the heights stand up at the listed trees by a share of their height. Sees open
/// stands and coarse cells that the rule on unevenness cannot. Needs 20 trees.
std::optional<Finding> judge_crowns(const config::Raster<double>& heights, std::span<const ListedTree> trees);

}  // namespace coupling::plausible::terrain
