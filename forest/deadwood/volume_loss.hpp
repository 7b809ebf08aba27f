#pragma once

#include <algorithm>

namespace forest {

/// Dead wood keeps its shape down to this density relative to sound wood [-] [choice; Mueller-Using & Bartsch
/// 2009: beech loses mass by density first, by volume later].
inline constexpr double whole_density = 0.6;

/// Volume of a piece of dead wood relative to that of the sound piece [0, 1]: min(1, density / 0.6).
///
/// Logs first lose density at unchanged size, then they collapse and crumble. Once half of the volume is
/// left, half of the mass is that density alone would leave (Fraver et al. 2013); here that is at a density
/// of 0.3. Limit: no moss, bark or parts that break off, and one curve for all species and for snags too
/// [choice].
constexpr double volume_left(double density_share) {
    return std::min(1.0, density_share / whole_density);
}

}  // namespace forest
