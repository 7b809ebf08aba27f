#pragma once

#include <Eigen/Core>
#include <vector>

#include "rockfall/rock_mass/placed_block.hpp"
#include "rockfall/rock_mass/polygon.hpp"
#include "rockfall/solids/hull.hpp"

namespace rockfall::rock_mass {

/// A convex body as a list of faces with corners of their own, for cutting.
struct CellFace {
    Plane3 plane;                            ///< outward unit normal
    std::vector<Eigen::Vector3d> corners_m;  ///< counter-clockwise seen from outside
    int made_by = 0;                         ///< what cut it: whoever cuts says what the number means
};
struct ConvexCell {
    std::vector<CellFace> faces;  ///< none: the cell is empty
};

ConvexCell box_cell(const Eigen::Vector3d& low_m, const Eigen::Vector3d& high_m, int made_by);
ConvexCell cell_of(const PlacedBlock& block);
ConvexCell cell_of(const solids::Hull& hull, int made_by);

/// The part of a cell where normal . x <= offset_m; its new face is made by `made_by`. Any length of the
/// normal will do. A cell that the plane does not cut stays as it is; corners within 1e-9 m of the plane lie
/// on it.
ConvexCell part_below(const ConvexCell& cell, const Plane3& plane, int made_by = 0);

struct VolumeAndCentre {
    double volume_m3 = 0.0;
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
};
VolumeAndCentre volume_and_centre(const ConvexCell& cell);

/// How large a cell is [m]: the smaller of the sides of two cubes, one of equal volume and one of equal
/// volume by surface, 6 V / A. So thin plates and wedges count as small.
double size_m(const ConvexCell& cell);

/// Lowest and highest value of direction . x over a cell. Requires a cell that is not empty.
struct Span1 {
    double low;
    double high;
};
Span1 extent_along(const ConvexCell& cell, const Eigen::Vector3d& direction);

/// All corners of all faces, each as often as it has faces.
std::vector<Eigen::Vector3d> corners_of(const ConvexCell& cell);

}  // namespace rockfall::rock_mass
