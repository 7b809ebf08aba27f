#pragma once

namespace rockfall {

/// A lying log as the world describes it: a cylinder between two points that follows the ground. Plan
/// positions in absolute coordinates.
struct Log {
    double x1_m = 0.0;  ///< one end
    double y1_m = 0.0;
    double x2_m = 0.0;  ///< the other end
    double y2_m = 0.0;
    double diameter1_cm = 0.0;     ///< at the first end, (0, 500]
    double diameter2_cm = 0.0;     ///< at the second end, (0, 500]
    double clearance_m = 0.0;      ///< from the ground to the underside, normal to the ground, [0, 20]
    double fracture_energy = 1.0;  ///< of the species, relative to Abies alba [-]
    double strength = 1.0;         ///< share of that of fresh wood, falls with decay [0, 1]; 0: no obstacle
    bool supported = false;        ///< leans on stumps or trees, or is anchored
};

}  // namespace rockfall
