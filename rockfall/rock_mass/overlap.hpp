#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "rockfall/rock_mass/placed_block.hpp"

namespace rockfall::rock_mass {

/// Integrals over the surface of the overlap of two bodies, for a pressure of 1 per metre of depth.
///
/// All places are relative to a point that the caller chose.
struct Overlap {
    Eigen::Vector3d force_m3 = Eigen::Vector3d::Zero();    ///< on the second body: integral of -depth m dS
    Eigen::Vector3d moment_m4 = Eigen::Vector3d::Zero();   ///< of it about the chosen point
    double depth_m3 = 0.0;                                 ///< integral of depth dS, without direction
    double depth_squared_m4 = 0.0;                         ///< of depth^2 dS, rims as if below their face
    Eigen::Vector3d depth_m4 = Eigen::Vector3d::Zero();    ///< integral of depth x dS
    Eigen::Vector3d area_m2 = Eigen::Vector3d::Zero();     ///< integral of -m dS over the second body's part
    double surface_m2 = 0.0;                               ///< area of all pieces, without direction
    Eigen::Vector3d surface_m3 = Eigen::Vector3d::Zero();  ///< integral of x dS over them
    double friction_radius_m = 0.0;  ///< mean distance of the pressure from its centre, along the contact
    /// Arms of the pressure about its centre, along the contact: across each other, as long as the root mean
    /// square of its distance along them.
    std::array<Eigen::Vector3d, 2> arms_m{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    double gap_m = 0.0;  ///< where there is none: how far apart the bodies are at least

    /// Bodies that touch within rounding do not overlap: their force would have any direction.
    [[nodiscard]] bool is_none() const {
        constexpr double least_depth_m = 1e-9;
        const double least_m3 = least_depth_m * surface_m2;
        return force_m3.squaredNorm() <= least_m3 * least_m3 || depth_m3 <= least_m3;
    }
    /// Mean square of the depth by the square of its mean, less 1 [-]. Requires an overlap.
    [[nodiscard]] double unevenness() const {
        return depth_squared_m4 * surface_m2 / (depth_m3 * depth_m3) - 1.0;
    }
    /// Where the pressure acts: among the pieces, whatever their directions. Requires an overlap.
    [[nodiscard]] Eigen::Vector3d pressure_centre_m() const { return depth_m4 / depth_m3; }
    /// Middle of the surfaces that lie in the other body. Requires an overlap.
    [[nodiscard]] Eigen::Vector3d surface_centre_m() const { return surface_m3 / surface_m2; }
};

/// An overlap while its pieces are summed up.
struct OverlapSums : Overlap {
    Eigen::Matrix3d squares_m5 = Eigen::Matrix3d::Zero();  ///< integral of depth x x^T dS

    /// With its arms and the friction radius: that of the rectangle under even pressure with the same second
    /// moments of pressure about its centre. Exact for rectangles, 0.6 % too small for discs.
    [[nodiscard]] Overlap finished() const;
};

/// How force and moment of an overlap change with a small shift and turn of the second body against the first
/// one, in the axes of space; turns and moments about the point of the moment, which goes with the second
/// body.
struct OverlapSlope {
    Eigen::Matrix3d force_by_shift = Eigen::Matrix3d::Zero();   ///< [m2]
    Eigen::Matrix3d force_by_turn = Eigen::Matrix3d::Zero();    ///< [m3]
    Eigen::Matrix3d moment_by_shift = Eigen::Matrix3d::Zero();  ///< [m3]
    Eigen::Matrix3d moment_by_turn = Eigen::Matrix3d::Zero();   ///< [m4]

    /// Adds a piece of a face with outward normal m, below a plane of the other body. Its border counts for
    /// nothing: there the depth is 0, or another piece goes on.
    void add(const Polygon2& piece, const FaceFrame& frame, const Eigen::Vector3d& m,
             const Eigen::Vector3d& plane_normal, const Eigen::Vector3d& about_m);
    /// Adds that a force on a surface turns with it.
    void turn_with(const Overlap& of_surface);
};

/// A face of the first or of the second block that had both of them on different sides, the direction midway
/// between two faces of it, or any other one: looked at first.
struct SeparatingFace {
    static constexpr std::uint16_t none = 0xFFFF;
    std::uint16_t face = none;
    std::uint16_t other_face = none;  ///< of the same block: an edge, not a face, keeps the two apart
    bool of_second = false;
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();  ///< unit, from the first to the second block; 0: none

    [[nodiscard]] bool has_axis() const { return !axis.isZero(0.0); }
    /// No face keeps the two apart, so that they pass each other at edges or corners.
    [[nodiscard]] bool is_edge() const { return other_face != none || has_axis(); }
    /// With first and second block exchanged.
    void reverse() {
        of_second = !of_second;
        axis = -axis;
    }
};

/// How far a known face or edge keeps two blocks apart [m]: below 0 if it does not, or if there is none.
double separation_m(const SeparatingFace& known, const PlacedBlock& first, const PlacedBlock& second);

/// How far two blocks that pass each other at edges may go into each other, turns included, before the force
/// could exceed `slack_m3` for c = 1: it is at most depth x length x width. The width grows with the depth,
/// the faster the flatter the faces lie to the direction that keeps the two apart; where none is known it is
/// that of the smaller block.
double way_into_edge_m(const SeparatingFace& known, const PlacedBlock& first, const PlacedBlock& second,
                       double slack_m3);

/// Adds what was summed up over a face with outward unit normal m.
void add_face(const FaceFrame& frame, const Eigen::Vector3d& m, const FaceSums& sums,
              const Eigen::Vector3d& about_m, OverlapSums& sum);

/// The elastic foundation between two convex blocks.
///
/// Each block is a foundation: inside it the pressure grows with the depth below its nearest face, p = c
/// depth. The energy of a pair is half of what each foundation holds of the other,
///     U = (c / 2) (integral over A and B of depth_A dV + the same of depth_B),
/// which for two faces on each other is (c / 2) A depth^2, and the force is its exact gradient,
///     F = -(c / 2) integral over the surface of B in A of depth_A m dS + the same of A in B.
/// So faces, edges and corners go over into each other without a jump, contact takes no energy and gives
/// none, whatever the shape, and corners need no law of their own. After the pressure fields of Elandt et al.
/// (2019, IROS, doi 10.1109/IROS40897.2019.8968548); c is E* / L (README of the room).
///
/// Exact clipping of the faces of one block by those of the other. `known` is renewed.
/// `slope`: computed where it is asked for, with `about_m` the centre of the second block.
/// `were_apart`: where no face keeps the two apart, a direction that does is looked for before anything is
/// clipped.
Overlap overlap_of(const PlacedBlock& first, const PlacedBlock& second, const Eigen::Vector3d& about_m,
                   SeparatingFace& known, OverlapSlope* slope = nullptr, bool were_apart = false);

/// The energy of the same for c = 1 [m4]: exact, by dividing the overlap where the nearest face changes.
double overlap_energy_m4(const PlacedBlock& first, const PlacedBlock& second);

}  // namespace rockfall::rock_mass
