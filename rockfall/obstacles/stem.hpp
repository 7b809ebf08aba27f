#pragma once

#include <cstdint>

#include "config/math/elementary.hpp"

namespace rockfall {

/// A standing stem as the world describes it: a tree, a snag or a high stump; positions in absolute
/// coordinates.
struct Stem {
    double x_m = 0.0;
    double y_m = 0.0;
    double dbh_cm = 0.0;           ///< diameter 1.3 m above ground, (0, 500]
    double height_m = 0.0;         ///< (0, 150]
    double fracture_energy = 1.0;  ///< relative to Abies alba [-]
    double strength = 1.0;         ///< share of that of sound wood, falls with decay and wounds [0, 1]
    double broken_at_m = 0.0;      ///< > 0: ends at this height, `height_m` being that of the whole tree
};

/// Height above ground at which the DBH is taken.
inline constexpr double breast_height_m = 1.3;

/// Diameter at a height divided by the DBH [-].
///
/// Above breast height ((H - h) / (H - 1.3))^0.8, below it 15 % more per metre. Choice, no published law for
/// rockfall; a stem of at most 1.3 m height counts as a cylinder.
inline double taper(double height_above_ground_m, double tree_height_m) {
    if (height_above_ground_m <= breast_height_m) {
        return 1.0 + 0.15 * (breast_height_m - (height_above_ground_m > 0.0 ? height_above_ground_m : 0.0));
    }
    if (height_above_ground_m >= tree_height_m) {
        return 0.0;
    }
    return config::pow_of((tree_height_m - height_above_ground_m) / (tree_height_m - breast_height_m), 0.8);
}

/// Taper at the ground: the thickest a stem gets.
inline constexpr double taper_at_ground = 1.0 + 0.15 * breast_height_m;

}  // namespace rockfall
