#pragma once

#include <algorithm>

#include "rockfall/laws/restitution.hpp"
#include "rockfall/motion/classical/law.hpp"
#include "rockfall/slope/slope.hpp"

namespace rockfall::classical {

/// The friction that lumped-mass programs derive from r_t: (1 - r_t) / r_t [-].
inline double friction_from_rt(const SurfaceType& ground) {
    // A ground that takes all of the speed along it lets nothing slide.
    constexpr double least_rt = 1e-3;
    const double r_t = std::max(ground.as_published().tangential, least_rt);
    return std::max(0.0, (1.0 - r_t) / r_t);
}

/// Whether a ground type says what slides on it.
inline bool has_own_friction(const SurfaceType& ground) {
    return ground.sliding_friction > 0.0 || ground.soil.has_value();
}

/// Coefficient of sliding friction of a ground [-], from where the law says. A ground without one of its own
/// has that from r_t; `Model::doubts` names such grounds.
inline double friction_of(const SurfaceType& ground, const Law& law) {
    switch (law.friction) {
        case Friction::angle:
            return law.friction_angle_tangent;
        case Friction::ground:
            if (has_own_friction(ground)) {
                return ground.sliding_friction > 0.0 ? ground.sliding_friction : ground.soil->friction;
            }
            break;
        case Friction::from_rt:
            break;
    }
    return friction_from_rt(ground);
}

}  // namespace rockfall::classical
