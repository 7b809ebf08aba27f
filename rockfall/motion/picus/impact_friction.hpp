#pragma once

#include <Eigen/Core>
#include <cmath>

#include "rockfall/laws/restitution.hpp"

namespace rockfall::picus {

/// What stops the slip of a sphere that does not spin; friction takes no more of the speed along the ground.
/// An impulse P takes P / m from the speed of the centre and gives R P / I to the spin. The slip ends at the
/// share 1 / (1 + m R2 / I), with I = 0.4 m R2 two sevenths.
inline constexpr double largest_friction_share = 2.0 / 7.0;

/// Coefficients of an impact that takes, on average, at least what dry friction takes: of the speed along the
/// ground mu (1 + r_n) times the speed into it (impulsive Coulomb friction), at most 2/7 of itself.
///
/// A constant share takes little from a rock that hops slowly down a gentle slope, and it would hop on for
/// ever where it could not roll. Requires a unit normal, a velocity into the ground and mu >= 0.
inline Restitution with_friction(Restitution usual, const Eigen::Vector3d& velocity_mps,
                                 const Eigen::Vector3d& normal, double friction) {
    const double usual_share = 1.0 - usual.tangential;
    if (usual_share >= largest_friction_share) {
        return usual;
    }
    const double into_mps = -velocity_mps.dot(normal);
    const double taken_mps = friction * (1.0 + usual.normal) * into_mps;
    const double squared_along = (velocity_mps + into_mps * normal).squaredNorm();
    if (taken_mps * taken_mps <= usual_share * usual_share * squared_along) {
        return usual;
    }
    // A rock that falls straight onto the ground has no speed along it: the share is the largest one.
    const double most_mps = largest_friction_share * std::sqrt(squared_along);
    return {usual.normal, 1.0 - (taken_mps >= most_mps ? largest_friction_share
                                                       : largest_friction_share * taken_mps / most_mps)};
}

}  // namespace rockfall::picus
