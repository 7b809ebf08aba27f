#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace rockfall {

/// How readily the ground stops a rock, by its diameter: the probability at an impact [-], or the rate while
/// it rolls [1/m].
///
/// Straight between the knots in ln D, constant beyond them (Rammer et al. 2010, section 3.2.2: one
/// probability for each surface and rock size, from virtual surfaces).
class StopCurve {
public:
    StopCurve() = default;  ///< never stops
    /// Knots as (diameter_m, value). Requires diameters > 0 that rise strictly and values >= 0.
    explicit StopCurve(std::vector<std::pair<double, double>> knots);
    [[nodiscard]] double at(double diameter_m) const;
    /// Every value times a factor >= 0, cut off at `most`.
    [[nodiscard]] StopCurve times(double factor, double most) const;

private:
    std::vector<std::pair<double, double>> knots_;  // (ln diameter, value)
};

/// When a rock stops beside chance and trees.
struct StoppingLaw {
    bool by_chance = true;        ///< use the probabilities of the surfaces
    bool catches_rolling = true;  ///< those of rolling rocks too
    double slow_mps =
        0.5;  ///< after an impact on ground flatter than the friction angle, a slower rock rests
    std::uint32_t most_impacts = 20'000;  ///< a rock that jumps for ever is ended and counted as such
};

}  // namespace rockfall
