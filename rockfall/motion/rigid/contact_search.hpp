#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "rockfall/motion/rigid/body.hpp"
#include "rockfall/motion/rigid/ground_patch.hpp"
#include "rockfall/solids/mass_properties.hpp"

namespace rockfall::rigid {

/// A place where block and ground touch, or would at a gap of 0.
struct TouchPoint {
    Eigen::Vector3d point_m;  ///< on the ground
    Eigen::Vector3d normal;   ///< unit, from the ground to the block
    double gap_m;             ///< along the normal; negative where they overlap
    std::uint32_t triangle;   ///< whose ground type counts
    std::uint32_t feature;    ///< of the block: the same vertex, edge or face keeps its number
};

/// A block in space with its vertices where they are now.
struct PosedBlock {
    const solids::Solid* solid = nullptr;
    Eigen::Vector3d centre_m;
    Eigen::Matrix3d turn;                     ///< from the principal axes to space
    std::vector<Eigen::Vector3d> vertices_m;  ///< in space; none of a sphere
    std::vector<Eigen::Vector3d> normals;     ///< of its faces, in space

    void pose(const solids::Solid& of, const Eigen::Vector3d& place_m, const Eigen::Quaterniond& attitude);
    [[nodiscard]] bool is_sphere() const { return solid->is_sphere(); }
};

/// Finds where a block touches the ground of a patch, gaps up to `reach_m`.
///
/// A sphere touches triangles, ridges and peaks with its nearest point. A polyhedron touches with its
/// vertices (the triangle below or above each, in plan), with its faces on peaks, and with its edges across
/// ridges; the latter two only within their Voronoi regions, so that neighbours in one plane touch once.
void find_touches(const GroundPatch& patch, const PosedBlock& block, double reach_m,
                  std::vector<TouchPoint>& found);

/// Leaves at most four points: the deepest, and those that span the largest support with it.
void keep_four(std::vector<TouchPoint>& touches);

/// How a free block moves, as far as bounds ask.
struct FreeMotion {
    Eigen::Vector3d velocity_mps;
    Eigen::Vector3d spin_radps;
    double largest_spin_radps;  ///< at any later time: |L| / I_min
};

/// A time before which the free block cannot come to touch the ground of the patch: each point's gap shrinks
/// no faster than its present rate and the largest acceleration allow. Ridges that no plane separates from
/// the block count with the time in which it moves by a fiftieth of its radius, as contacts with them are
/// found from gaps below 0.
double free_time_s(const GroundPatch& patch, const PosedBlock& block, const FreeMotion& motion);

/// The first time after `from_s` at which the ball around a block can touch a triangle, infinity if not
/// before `until_s`. A parabola over a plane is concave, so its two ends and one root decide.
struct BallFlight {
    Eigen::Vector3d centre_m;  ///< at time 0
    Eigen::Vector3d velocity_mps;
    double radius_m;
};
double first_possible_touch_s(const NearTriangle& triangle, const BallFlight& ball, double from_s,
                              double until_s);

}  // namespace rockfall::rigid
