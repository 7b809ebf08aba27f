#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "rockfall/solids/hull.hpp"

namespace rockfall::solids {

/// Which features of block and ground touch.
enum class ContactKind : std::uint8_t {
    vertex_on_face,  ///< a vertex of the block on a triangle
    face_on_vertex,  ///< a face of the block on a vertex of the ground
    edge_on_edge,    ///< an edge of the block across an edge of the ground
};

/// A place where block and ground touch, or would at a gap of 0.
struct GroundContact {
    ContactKind kind;
    Eigen::Vector3d point_m;  ///< on the ground
    Eigen::Vector3d normal;   ///< unit, from the ground to the block
    double gap_m;             ///< along the normal; negative where they overlap
};

/// A triangle of the ground, counter-clockwise seen from above.
struct GroundTriangle {
    std::array<Eigen::Vector3d, 3> corners_m;
    Eigen::Vector3d normal;  ///< unit, upwards
};

/// An edge of the ground between two faces.
///
/// Seen from above the left face lies left of the way `from` -> `to`. At the border of the ground the normal
/// on the right is the horizontal or inclined one that points out of the left face in its plane.
struct GroundEdge {
    Eigen::Vector3d from_m;
    Eigen::Vector3d to_m;
    Eigen::Vector3d left_normal;
    Eigen::Vector3d right_normal;
};

/// Sine of the angle below which two faces of the ground are one plane, and below which two edges are
/// parallel
/// [-]. Flat neighbours so give no contact at their edge, however the plane was divided into triangles.
inline constexpr double parallel_sine = 1e-7;

// The three kinds of contact of two polyhedra (Leine et al. 2014, Multibody Syst. Dyn. 32:241, has the first;
// the ridges of a fine terrain between the vertices of a plate need the others). `block` is a hull in the
// axes of space. Only gaps up to `reach_m` either way count.

/// Vertices of the block whose foot lies on the triangle, its border included.
std::vector<GroundContact> vertices_on(const GroundTriangle& triangle, const Hull& block, double reach_m);

/// A vertex of the ground against the nearest face of the block, where its foot lies on that face and the
/// face looks down on the ground.
std::optional<GroundContact> face_on(const Eigen::Vector3d& ground_vertex_m, const Hull& block,
                                     double reach_m);

/// Edges of the block across a ridge of the ground.
///
/// The normal is that of both edges. It counts where it lies between the normals of the two faces at either
/// edge (the Voronoi region of the edge), so that a contact belongs to one pair of features only. Edges in
/// valleys and between faces in one plane touch nothing.
std::vector<GroundContact> edges_across(const GroundEdge& ridge, const Hull& block, double reach_m);

}  // namespace rockfall::solids
