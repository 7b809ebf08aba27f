#pragma once

#include <cstdint>
#include <string>

namespace rockfall {

/// How friction grows with the way of a contact.
enum class FrictionLaw : std::uint8_t {
    constant,  ///< mu
    slip,      ///< from mu to mu_max with the slip
};

/// What sets a ground type apart for a rigid block. Unless said otherwise friction is that of the class
/// `hard` of the shipped table of grounds for blocks.
struct BlockGround {
    std::string name;
    FrictionLaw law = FrictionLaw::slip;
    double friction = 0.55;            ///< mu, or mu_min of the slip law [-], [0, 10]
    double friction_max = 2.0;         ///< mu_max of the slip law [-], not below `friction`
    double slip_beta_ps = 185.0;       ///< decay of the slip without contact [1/s], >= 0
    double slip_kappa_pm = 3.0;        ///< growth of friction with the slip [1/m], >= 0
    double drag_ps = 0.5;              ///< drag in contact, proportional to the velocity [1/s], >= 0
    double restitution = 0.0;          ///< e of slow impacts [-], [0, 1]
    double rolling_resistance = 0.02;  ///< mu_r: couple mu_r N r against the spin [-], [0, 10]
    double soil_strength_kpa = 0.0;    ///< M_e of scars [kN/m2]; 0: the ground takes none
};

}  // namespace rockfall
