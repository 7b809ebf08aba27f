#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

namespace rockfall::solids {

/// A plane face of a convex solid.
struct Face {
    std::vector<std::uint32_t> corners;  ///< indices of vertices, counter-clockwise seen from outside
    Eigen::Vector3d normal;              ///< unit, outwards
    double offset_m;                     ///< the plane is normal . x = offset_m
};

/// An edge of a convex solid between the two faces that it separates.
struct Edge {
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t left;   ///< face in which the edge runs from `from` to `to`
    std::uint32_t right;  ///< face in which it runs back
};

/// A convex solid: all of its vertices are corners of at least three faces, and coplanar triangles are one
/// face. Made by convex_hull only.
struct Hull {
    std::vector<Eigen::Vector3d> vertices_m;
    std::vector<Face> faces;
    std::vector<Edge> edges;
};

/// The points span no solid. The text says what was found; whoever read the points adds where they stood.
class NoSolid : public std::invalid_argument {
public:
    using std::invalid_argument::invalid_argument;
};

/// Thickness below which points count as flat, and depth within which they count as lying on a face, divided
/// by the largest extent of the points [-].
inline constexpr double flatness = 1e-9;

/// The convex hull of points (quickhull: Barber, Dobkin & Huhdanpaa 1996, ACM Trans. Math. Softw. 22:469).
///
/// Points inside or on the hull are left out. The result depends on the order of the points only in how
/// vertices and faces are numbered. Throws NoSolid for fewer than four points, coordinates that are no
/// numbers, and points that coincide, lie on a line or in a plane.
Hull convex_hull(std::span<const Eigen::Vector3d> points_m);

/// A convex solid given by its faces, such as a mesh that somebody else made. Throws NoSolid for indices that
/// name no vertex, faces that point inwards or do not close, and solids that are not convex.
Hull hull_of_faces(std::span<const Eigen::Vector3d> points_m,
                   std::span<const std::vector<std::uint32_t>> faces);

/// The solid scaled about the origin. Requires positive factors.
Hull scaled(const Hull& hull, const Eigen::Vector3d& factors);

/// The solid turned about the origin and then moved. Requires a unit quaternion.
Hull placed(const Hull& hull, const Eigen::Quaterniond& attitude, const Eigen::Vector3d& position_m);

}  // namespace rockfall::solids
