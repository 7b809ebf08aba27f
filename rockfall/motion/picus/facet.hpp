#pragma once

#include <Eigen/Core>

#include "rockfall/laws/contact.hpp"

namespace rockfall::picus {

/// Roughness of ground and rock as facets that lean along the path, their slopes against the ground uniform
/// between -s and s.
///
/// Ground that takes more of the speed along it is rougher: s grows with the losses 1 - r_t [choice; fitted
/// to single rebounds, see validation/README.md]. A rock meets a facet with the probability of the area that
/// it turns towards the rock: those that face it more often.
struct FacetLaw {
    double slope_by_losses = 2.5;  ///< s by 1 - r_t, as a tangent [-]; 0: even ground

    [[nodiscard]] bool any() const { return slope_by_losses > 0.0; }
    [[nodiscard]] double steepest(double tangential_restitution) const {
        return slope_by_losses * (1.0 - tangential_restitution);
    }
};

/// Unit normal of the facet that a rock meets where facets are up to `steepest` against the ground (a
/// tangent); `draw` on [0, 1). Requires a unit normal and a velocity into the ground; so is that into the
/// facet.
Eigen::Vector3d facet_normal(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& normal,
                             double steepest, double draw);

/// A contact with a facet seen from the ground: a rock that would leave into the ground rolls along it
/// instead, and rolling goes along the ground. Energy never rises.
Contact on_ground(Contact contact, const Eigen::Vector3d& normal);

}  // namespace rockfall::picus
