#pragma once

#include <cstdint>

namespace rockfall::rock_mass {

/// How the normal force of a contact follows from the overlap.
enum class ContactLaw : std::uint8_t {
    foundation,  ///< elastic foundation: exact gradient of an energy
    pfc,         ///< one spring a pair at the middle of the contact, as the rigid blocks of PFC3D
};

/// All constants of the laws of a rock mass.
struct Laws {
    ContactLaw contact = ContactLaw::foundation;
    bool disc_areas = false;  ///< pfc: contact area of a disc of the smaller block instead of the polygon's
    double modulus_pa = 1e8;  ///< effective modulus E* of contacts and bonds
    double stiffness_ratio = 2.5;     ///< normal by shear stiffness [-], > 0
    double friction = 0.3;            ///< between blocks [-]
    double ground_friction = 0.3;     ///< between block and ground [-]
    double damping_ratio = 0.5;       ///< of the dashpot at contacts, by the critical one [-], [0, 1]
    double bond_damping_ratio = 0.0;  ///< the same at intact bonds [-]
    double local_damping = 0.0;  ///< force taken off by share of its size, as PFC's local damping [-], [0, 1)
    double strength_angle_tan = 0.0;  ///< of shear strength: tau_c = c + sigma tan(phi) [-]
    double step_factor = 0.2;         ///< time step by the smallest 2 sqrt(m / sum k) [-], (0, 0.5]
    double heavier_share = 0.0;       ///< of the blocks, the thinnest, whose mass is scaled up [-], [0, 0.1]
    double gravity_mps2 = 9.81;
    bool sleeping = true;  ///< blocks at rest are left out until something moves them
};

}  // namespace rockfall::rock_mass
