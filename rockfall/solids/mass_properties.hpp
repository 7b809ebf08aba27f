#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "rockfall/solids/hull.hpp"

namespace rockfall::solids {

/// Integrals over the volume of a solid of density 1.
struct VolumeIntegrals {
    double volume_m3;
    Eigen::Vector3d centroid_m;
    Eigen::Matrix3d inertia_m5;  ///< about the centroid, in the axes of the solid
};

/// Exact integrals of a polyhedron as sums over its faces (Mirtich 1996, J. Graphics Tools 1(2):31; in the
/// form of tetrahedra between the faces and one point, Eberly 2002, Polyhedral Mass Properties).
VolumeIntegrals volume_integrals(const Hull& hull);

/// Principal moments in ascending order and the rotation from principal axes to the axes of the tensor.
struct PrincipalAxes {
    Eigen::Vector3d moments;
    Eigen::Matrix3d axes;  ///< columns: unit, right-handed
};

/// Jacobi rotations until nothing is left off the diagonal (Golub & Van Loan, 8.5): only IEEE arithmetic, so
/// the same on every machine. A tensor that is diagonal in ascending order already keeps its axes.
PrincipalAxes principal_axes(const Eigen::Matrix3d& symmetric);

/// A solid block in its principal axes with the centroid at the origin.
struct Solid {
    Hull hull;
    double volume_m3;
    double mass_kg;
    Eigen::Vector3d inertia_kgm2;   ///< principal moments, ascending
    Eigen::Vector3d centroid_m;     ///< of the hull as it was given
    Eigen::Quaterniond from_given;  ///< turns vectors from the given axes to the principal axes
    double bounding_radius_m;       ///< distance of the farthest vertex from the centroid
    /// Diameter of the sphere of equal volume.
    [[nodiscard]] double diameter_m() const;
    /// A ball has no vertices.
    [[nodiscard]] bool is_sphere() const { return hull.vertices_m.empty(); }
};

/// Requires a positive density.
Solid solid_of(const Hull& hull, double density_kgpm3);

/// A ball: a solid without vertices whose bounding radius is its radius. Requires positive numbers.
Solid ball_of(double diameter_m, double density_kgpm3);

}  // namespace rockfall::solids
