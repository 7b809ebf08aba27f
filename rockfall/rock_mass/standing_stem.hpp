#pragma once

namespace rockfall::rock_mass {

/// A tree in the way: a vertical cylinder that takes energy until it is broken.
struct StandingStem {
    double x_m = 0.0;
    double y_m = 0.0;
    double ground_m = 0.0;
    double top_m = 0.0;  ///< where it ends, absolute
    double radius_m = 0.0;
    double strength_j = 0.0;  ///< energy that breaks it
    double taken_j = 0.0;     ///< so far
    bool felled = false;      ///< by a block that goes on under another motion model

    [[nodiscard]] bool is_broken() const { return felled || taken_j >= strength_j; }
};

}  // namespace rockfall::rock_mass
