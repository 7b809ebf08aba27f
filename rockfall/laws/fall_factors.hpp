#pragma once

namespace rockfall {

/// Factors on the laws of a fall, for what is not known about them: 1 leaves a law as it is.
struct FallFactors {
    double losses = 1.0;       ///< on what contacts take from the speed along the ground (1 - r_t) [-]
    double friction = 1.0;     ///< on the friction of rolling and sliding rocks [-]
    double stopping = 1.0;     ///< on the chance that the ground stops a rock [-]
    double jump_angle = 1.0;   ///< on the angle at which rocks leave the ground [-]
    double sideways = 1.0;     ///< on the largest turn sideways at an impact [-]
    double tree_energy = 1.0;  ///< on the energy that stems and logs take [-]
    double block_size = 1.0;   ///< on the diameter of rocks whose source has no sizes of its own [-]
};

}  // namespace rockfall
