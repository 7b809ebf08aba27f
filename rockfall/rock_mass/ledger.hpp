#pragma once

#include "rockfall/rock_mass/bond.hpp"

namespace rockfall::rock_mass {

/// All energies of a rock mass at a time [J].
struct Ledger {
    double translation_j = 0.0;
    double rotation_j = 0.0;
    double gravity_j = 0.0;         ///< of the height above the start; falls as the mass comes down
    double contact_normal_j = 0.0;  ///< held by contacts
    double contact_shear_j = 0.0;
    BondEnergy bonds;         ///< held by intact bonds
    double friction_j = 0.0;  ///< taken out so far, as all below
    double dashpot_j = 0.0;
    double local_damping_j = 0.0;
    double fracture_j = 0.0;  ///< never falls
    double trees_j = 0.0;
    double rest_j = 0.0;  ///< motion of blocks when they were put to rest
    double left_j = 0.0;  ///< of blocks that left the area
    // Of blocks that go on under another motion model, as they were when they left the mass.
    double handed_motion_j = 0.0;
    double handed_gravity_j = 0.0;  ///< of their height above their start; below 0 as a rule
    double handed_strain_j = 0.0;   ///< held by their contacts with the ground, lost then
    // The same of those that came back, as they were then.
    double back_motion_j = 0.0;
    double back_gravity_j = 0.0;
    double back_strain_j = 0.0;  ///< of overlaps with other blocks with which they came
    double start_j = 0.0;        ///< sum of all at the start

    [[nodiscard]] double held_j() const {
        return translation_j + rotation_j + gravity_j + contact_normal_j + contact_shear_j + bonds.sum_j();
    }
    [[nodiscard]] double taken_j() const {
        return friction_j + dashpot_j + local_damping_j + fracture_j + trees_j + rest_j + left_j + handed_j();
    }
    /// Less what came back.
    [[nodiscard]] double handed_j() const {
        return handed_motion_j + handed_gravity_j + handed_strain_j - back_motion_j - back_gravity_j -
               back_strain_j;
    }
    /// What gravity gave so far, to blocks while they were part of the mass.
    [[nodiscard]] double given_by_gravity_j() const {
        return -(gravity_j + handed_gravity_j - back_gravity_j);
    }
    /// What is there too much; 0 if every energy is accounted for.
    [[nodiscard]] double residual_j() const { return held_j() + taken_j() - start_j; }
    /// Energy turned over so far: the largest of what gravity gave and what motion and bonds began with.
    [[nodiscard]] double turnover_j(double motion_at_start_j) const {
        const double given_j = given_by_gravity_j();
        return given_j > motion_at_start_j ? given_j : motion_at_start_j;
    }
};

}  // namespace rockfall::rock_mass
