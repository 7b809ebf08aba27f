#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "config/grid/raster.hpp"

namespace rockfall {

/// The surface that a rock of finite size feels: at each point the height of the plane that fits the terrain
/// best (least squares, weighted) around it.
///
/// Its normal is the mean normal of the terrain inside the contact zone, the remedy that Rammer et al. 2010
/// (discussion) propose against point slope angles of the TIN. The weight is Cleveland's (1979) tricube
/// (1 - (d/r)^3)^3 of the plan distance d and falls to zero at r = `support_radius_m`; what is smaller than
/// the support goes. Planes stay exactly as they are, at borders and beside holes too. A point whose
/// neighbours fix no plane (none within the radius, or all in one line) stays where it is, so a radius up to
/// the spacing of the points, and 0, return the input.
///
/// No plane is fitted across faces that differ by more than 35 degrees, as at the foot or the edge of a wall:
/// there the zone shrinks until it lies on one face, and a point right at the break stays.
///
/// No point moves by more than `largest_shift_m`, so cliffs and edges higher than that stay about where they
/// are. Shifts are cut off there, not eased in: a triangulation has a kink at each edge anyway, and easing in
/// leaves part of the noise behind. A limit of 0 returns the input, infinity sets none.
///
/// Missing heights (NaN) stay missing and have no weight.
config::Raster<double> contact_zone(const config::Raster<double>& heights, double support_radius_m,
                                    double largest_shift_m);
std::vector<Eigen::Vector3d> contact_zone(std::span<const Eigen::Vector3d> points, double support_radius_m,
                                          double largest_shift_m);

}  // namespace rockfall
