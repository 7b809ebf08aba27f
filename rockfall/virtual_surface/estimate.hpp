#pragma once

#include <cstdint>
#include <span>

#include "rockfall/virtual_surface/throws.hpp"

namespace rockfall {

/// A figure from several surfaces of one description, with what chance left open.
struct SurfaceEstimate {
    double value = 0.0;
    double standard_error = 0.0;  ///< over surfaces and throws together
};

/// Probability that an impact stops a rock [-]: stopped / thrown.
///
/// With the share p_i of each of S surfaces of n throws and their mean p, N = S n,
///
///     SE^2 = max( sum (p_i - p)^2 / (S (S - 1)),  q (1 - q) / N ),    q = (stopped + 1) / (N + 2)
///
/// The first term holds both the difference between surfaces and the chance of the throws, as the p_i are
/// independent and alike; the second is that of the throws alone, so that few surfaces which agree by
/// chance, or in which nothing stopped, do not pretend to be certain.
/// Requires at least one surface and the same number of throws, above 0, for each.
SurfaceEstimate stop_probability(std::span<const ThrowTally> surfaces);

/// Rate at which a rolling rock is caught [1/m]: stopped / length rolled until then, the estimate of greatest
/// likelihood where the chance is the same on every metre.
///
/// With k_i stops over l_i metres on each of S surfaces, the rate r and L = sum l_i,
///
///     SE^2 = max( S / (S - 1) sum (k_i - r l_i)^2,  k + 1 ) / L^2,    k = sum k_i
///
/// Requires at least one surface on which something rolled.
SurfaceEstimate rolling_stops_per_m(std::span<const RollTally> surfaces);

}  // namespace rockfall
