#pragma once

#include <algorithm>

namespace forest {

/// Dead wood keeps its shape down to this density relative to sound wood [-] [choice; Mueller-Using & Bartsch
/// 2009: beech loses mass by density first, by volume later].
inline constexpr double whole_density = 0.6;

/// Share of the volume of a stem that is bark [-]: spruce and fir have about a tenth, beech less, larch up to
/// twice as much [choice].
inline constexpr double bark_volume_share = 0.1;

/// Bark that is still on a piece of dead wood, relative to that of the sound piece [0, 1]: it comes off
/// evenly while the wood loses density, and all is gone at whole_density [choice].
constexpr double bark_left(double density_share) {
    return std::max(0.0, (density_share - whole_density) / (1.0 - whole_density));
}

/// Volume of a piece of dead wood relative to that of the sound piece over bark [0, 1]: min(1, density / 0.6)
/// of its wood and what is left of its bark.
///
/// Logs first lose bark, and density at unchanged size of the wood, then they collapse and crumble. Once half
/// of the wood's volume is left, half of the mass is that density alone would leave (Fraver et al. 2013);
/// here that is at a density of 0.3. Limit: no moss or parts that break off, and one curve for all species
/// and for snags too [choice].
constexpr double volume_left(double density_share) {
    return (1.0 - bark_volume_share) * std::min(1.0, density_share / whole_density) +
           bark_volume_share * bark_left(density_share);
}

}  // namespace forest
