#include "rockfall/motion/picus/facet.hpp"

#include <algorithm>
#include <cmath>

namespace rockfall::picus {

Eigen::Vector3d facet_normal(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& normal,
                             double steepest, double draw) {
    const double into_mps = -velocity_mps.dot(normal);
    const Eigen::Vector3d along_mps = velocity_mps + into_mps * normal;
    const double squared_along = along_mps.squaredNorm();
    // Straight from above facets lean no way that matters.
    constexpr double no_direction = 1e-12;
    if (squared_along <= no_direction * into_mps * into_mps) {
        return normal;
    }
    // In sight of the rock is of a facet of slope s the area into + along * s: linear in s, so that the share
    // of the facets below it is a square, and its inverse a root.
    const double along = std::sqrt(squared_along);
    const double least = std::max(0.0, into_mps - steepest * along);
    const double most = into_mps + steepest * along;
    const double seen = std::sqrt(least * least + draw * (most * most - least * least));
    const Eigen::Vector3d facet = normal - (seen - into_mps) / squared_along * along_mps;
    return facet / std::sqrt(facet.squaredNorm());
}

Contact on_ground(Contact contact, const Eigen::Vector3d& normal) {
    const double off_mps = contact.velocity_mps.dot(normal);
    if (contact.onward == Onward::rolls || (contact.onward == Onward::flies && off_mps <= 0.0)) {
        contact.velocity_mps -= off_mps * normal;
        contact.onward = Onward::rolls;
    }
    return contact;
}

}  // namespace rockfall::picus
