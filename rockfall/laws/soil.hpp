#pragma once

#include <string>

#include "config/units/angle.hpp"
#include "rockfall/laws/restitution.hpp"

namespace rockfall {

/// A half width (uniform) or standard deviation (normal) that falls with speed, straight to the limit speed
/// and then constant (Cottaz et al. 2010, Eqs. 6-9).
struct Width {
    double slow = 0.0;        ///< at rest
    double fast = 0.0;        ///< at and above the limit speed
    double limit_mps = 10.0;  ///< from this speed on it is constant
};

/// What sets one ground apart for motion models that take it from soils (Cottaz et al. 2010, Tables 1-3).
struct Soil {
    std::string name;
    Restitution restitution;
    double friction = 0.0;   ///< sliding friction coefficient k [-]
    Width normal_share;      ///< of R_N, relative to it [-]
    Width tangential_share;  ///< of R_T, relative to it [-]
    Width friction_share;    ///< of k, relative to it [-]
    Width sideways_rad;      ///< of the horizontal angle of a rebound
    Width upwards_rad;       ///< of the vertical angle of a rebound
    double threshold_tangent =
        0.0;  ///< tan of beta_lim, the angle to the ground that parts sliding from flight
};

}  // namespace rockfall
