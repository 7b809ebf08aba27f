#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "coupling/assessments/calibrate/model/sample.hpp"

namespace coupling::calibrate {

/// Distances that samples of the model itself show, each as large as what was observed: the scale by which
/// observations count. Forty scars count less than four hundred.
struct SelfDistance {
    std::vector<double> medians;  ///< of each observation, above 0
    double at_90 = 0.0;           ///< of all together: 90 % of such samples are nearer
    double at_95 = 0.0;

    /// All distances in one: the mean of each by its median.
    [[nodiscard]] double together(const std::vector<double>& distances) const;
};

/// `sets`: simulated samples of one parameter set, by set, by observation. `sizes`: how much was observed of
/// each; 0: it counts nothing. Draws by `seed` and `wave`.
SelfDistance self_distance(const std::vector<std::vector<Sample>>& sets,
                           const std::vector<std::size_t>& sizes, std::uint64_t seed, std::uint16_t wave);

/// So many points of several samples together, but not of that of number `without`, by chance and without
/// repetition as far as there are enough.
Sample drawn_from(const std::vector<const Sample*>& samples, std::size_t without, std::size_t points,
                  const std::function<double()>& uniform);

}  // namespace coupling::calibrate
