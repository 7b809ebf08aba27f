#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace rockfall::solids {

/// Attitude and angular momentum of a rigid body about its centroid.
struct Rotation {
    Eigen::Quaterniond attitude;   ///< unit: turns vectors of the body's principal axes into space
    Eigen::Vector3d momentum_nms;  ///< angular momentum in the principal axes [N m s]

    [[nodiscard]] Eigen::Vector3d momentum_in_space_nms() const { return attitude * momentum_nms; }
    /// Spin in the axes of space.
    [[nodiscard]] Eigen::Vector3d spin_radps(const Eigen::Vector3d& inertia_kgm2) const {
        return attitude * momentum_nms.cwiseQuotient(inertia_kgm2);
    }
    [[nodiscard]] double energy_j(const Eigen::Vector3d& inertia_kgm2) const {
        return 0.5 * momentum_nms.dot(momentum_nms.cwiseQuotient(inertia_kgm2));
    }
};

/// Longest step of rotate_free: the body turns by this angle at most [rad].
inline constexpr double longest_turn_rad = 0.02;

/// Free rotation over any time, in equal steps of at most `longest_turn_rad`.
///
/// Each step turns the body about its axes 1, 2, 3, 2, 1 by h/2, h/2, h, h/2, h/2 times L_i / I_i (Dullweber,
/// Leimkuhler & McLachlan 1997, J. Chem. Phys. 107:5840). The turns are exact rotations, so that the
/// momentum in space stays to rounding; the energy oscillates within the square of the step and does not
/// drift, whichever principal axis the body turns about.
///
/// Requires positive moments of inertia and a time of 0 or more.
Rotation rotate_free(Rotation start, const Eigen::Vector3d& inertia_kgm2, double time_s);

}  // namespace rockfall::solids
