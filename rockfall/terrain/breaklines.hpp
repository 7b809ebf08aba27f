#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "rockfall/terrain/terrain.hpp"

namespace rockfall {

/// Two points by their places in a list.
using PointPair = std::array<std::uint32_t, 2>;

/// Where two lines between points cross in plan within both, so that a place has two heights; nothing if none
/// do.
std::optional<Eigen::Vector2d> crossing_of(std::span<const Eigen::Vector3d> points,
                                           std::span<const PointPair> lines);

/// Constrained Delaunay triangulation of points in which each line is an edge, or several in a row where
/// points lie on it: contours, edges of cliffs and roads. Points at one place and long edges as for scattered
/// points (mesh.hpp). Requires lines that do not cross.
Terrain triangulate(std::span<const Eigen::Vector3d> points, std::span<const PointPair> lines,
                    double longest_edge_m);

}  // namespace rockfall
