#pragma once

#include <algorithm>

#include "rockfall/motion/classical/law.hpp"
#include "rockfall/motion/restitution.hpp"

namespace rockfall::classical {

/// Coefficient of sliding friction of a ground [-]: (1 - r_t) / r_t or that of one angle, as the law says.
inline double friction_of(Restitution restitution, const Law& law) {
    // A ground that takes all of the speed along it lets nothing slide.
    constexpr double least_rt = 1e-3;
    const double r_t = std::max(restitution.tangential, least_rt);
    return law.friction == Friction::angle ? law.friction_angle_tangent : std::max(0.0, (1.0 - r_t) / r_t);
}

}  // namespace rockfall::classical
