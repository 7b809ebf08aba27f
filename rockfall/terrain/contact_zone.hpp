#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "config/grid/raster.hpp"

namespace rockfall {

/// The surface that a rock of finite size feels: at each point the height of the plane that fits the terrain
/// best (weighted least squares, weight falling to zero at `support_radius_m`) around it.
///
/// Its normal is the mean normal of the terrain inside the contact zone, the remedy that Rammer et al. 2010
/// (discussion) propose against point slope angles of the TIN. Planes stay exactly as they are, at borders
/// and beside holes too; what is smaller than the support goes. No point moves by more than
/// `largest_shift_m`, so cliffs and edges higher than that stay where they are. A radius of 0 returns the
/// input.
config::Raster<double> contact_zone(const config::Raster<double>& heights, double support_radius_m,
                                    double largest_shift_m);
std::vector<Eigen::Vector3d> contact_zone(std::span<const Eigen::Vector3d> points, double support_radius_m,
                                          double largest_shift_m);

}  // namespace rockfall
