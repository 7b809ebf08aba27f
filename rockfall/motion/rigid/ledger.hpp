#pragma once

#include <algorithm>
#include <cmath>

namespace rockfall::rigid {

/// Where the energy of one rock went [J]. Losses are positive.
///
/// Each percussion does the work (U+ + U-)/2 . P, split along the normal and along the ground. A rock that is
/// lifted out of an overlap pays with its motion, and one that is lowered to the ground gains by it: the sum
/// of motion and height never rises. What is left is the error of the integration.
struct Ledger {
    double start_j = 0.0;       ///< kinetic and height energy at release
    double normal_j = 0.0;      ///< at contacts, along their normals
    double friction_j = 0.0;    ///< at contacts, along the ground
    double rolling_j = 0.0;     ///< rolling resistance
    double drag_j = 0.0;        ///< drag in contact and in scars
    double obstacles_j = 0.0;   ///< trees, logs, nets
    double other_j = 0.0;       ///< spin cap, and what is left where a rock comes to rest
    double correction_j = 0.0;  ///< of rocks that lie still and are lowered to the ground; never above 0

    [[nodiscard]] double dissipated_j() const {
        return normal_j + friction_j + rolling_j + drag_j + obstacles_j + other_j;
    }
    /// Energy at the end less what it should be.
    [[nodiscard]] double residual_j(double end_j) const {
        return end_j - (start_j + correction_j - dissipated_j());
    }
};

}  // namespace rockfall::rigid
