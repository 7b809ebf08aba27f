#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "config/grid/raster.hpp"

namespace coupling::grids {

/// The grid whose cell centres points are; cells without a point are NaN.
///
/// The size of the cells is the least distance between different coordinates, and each point lies within a
/// hundredth of a cell of a centre. Nothing comes back for other points: fewer than two columns or rows, a
/// lattice of which more than three quarters are empty, two heights at one place. The order of the points
/// does not count.
std::optional<config::Raster<double>> grid_of_points(const std::vector<Eigen::Vector3d>& points);

}  // namespace coupling::grids
