#pragma once

#include "config/math/elementary.hpp"
#include "config/units/constants.hpp"
#include "rockfall/motion/rigid/ground.hpp"

namespace rockfall::rigid {

/// Coefficient of friction after a slip s [m] (Leine et al. 2014, Multibody Syst. Dyn. 32:241, Eq. 46):
/// mu_min + 2/pi (mu_max - mu_min) arctan(kappa s). Soil piles up before a block that ploughs on.
inline double slip_friction(const Ground& ground, double slip_m) {
    if (ground.law == FrictionLaw::constant) {
        return ground.friction;
    }
    constexpr double two_by_pi = 0.636619772367581343075535053490057;
    return ground.friction + two_by_pi * (ground.friction_max - ground.friction) *
                                 config::atan_of(ground.slip_kappa_pm * slip_m);
}

/// The slip after a time (Leine et al. 2014, Eq. 47): it grows with the speed of the centroid while any
/// contact carries a force, else it decays as exp(-beta t).
inline double slip_without_contact_m(double slip_m, double beta_ps, double time_s) {
    return slip_m * config::exp_of(-beta_ps * time_s);
}

}  // namespace rockfall::rigid
