#pragma once

#include "config/math/elementary.hpp"

namespace rockfall {

/// A stem's energy grows with this power of its diameter (Rammer et al. 2010, Eq. 1).
inline constexpr double energy_power = 2.31;

/// Energy a stem can take from a central hit at breast height, in joules.
///
/// E_max = FE * 38.7 * DBH^2.31 with DBH in cm (Rammer et al. 2010, Eq. 1; Dorren & Berger 2006). The paper
/// prints kilojoules; only joules agree with its own rocks and with its own number of hits.
inline double largest_energy_j(double dbh_cm, double fracture_energy) {
    return fracture_energy * 38.7 * config::pow_of(dbh_cm, energy_power);
}

/// Energy that a stem takes at another height, from that at breast height and the diameter there divided by
/// the DBH [-]: the power of the diameter holds at every height. 0 where there is no stem. Choice; nothing is
/// published.
inline double energy_at_j(double breast_height_j, double relative_diameter) {
    return relative_diameter > 0.0 ? breast_height_j * config::pow_of(relative_diameter, energy_power) : 0.0;
}

/// Share of a stem's energy that a hit can use, by relative hit position e (0 central, 1 edge) [-].
///
/// Sigmoid of Dorren & Berger (2006) in the form of the Rockyfor3D manual; 0.98 at the centre, zero from
/// 0.746.
inline double usable_share(double relative_position) {
    constexpr double log2_of_10 = 3.321928094887362;
    const double power = config::exp2_of(log2_of_10 * (relative_position - 0.58) * 8.007);
    const double share = -0.046 + (0.98 + 0.046) / (1.0 + power);
    return share > 0.0 ? share : 0.0;
}

}  // namespace rockfall
