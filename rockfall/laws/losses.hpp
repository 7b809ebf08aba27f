#pragma once

#include <algorithm>

#include "config/math/elementary.hpp"
#include "rockfall/laws/restitution.hpp"
#include "rockfall/laws/rock.hpp"

namespace rockfall {

/// What stays with a rock all its way: how much more or less than the usual rock it loses at the ground.
///
/// What contacts take from the speed along the ground (1 - r_t), and the friction of rolling, are multiplied
/// by (elongation / usual)^power * exp(scatter * z), z of the rock. Chance that is drawn anew at each impact
/// averages out over a fall; this does not.
struct LossLaw {
    double by_elongation = 0.7;  ///< power of the elongation [-]
    double scatter = 0.15;  ///< standard deviation of ln(factor), of what the elongation does not say [-]
};

/// Of the rocks that ground values are fitted to: the longest side by the shortest of rock fragments
/// (2 : sqrt 2 : 1, Fujiwara et al. 1978).
inline constexpr double usual_elongation = 2.0;

/// The factor of a rock [-]; 1 of the usual one.
double loss_factor(const LossLaw& law, const Rock& rock);

/// Restitution of a rock that loses so many times what the usual one loses along the ground.
Restitution with_losses(Restitution usual, double factor);

}  // namespace rockfall
