#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "coupling/assessments/calibrate/model/sample.hpp"

namespace coupling::calibrate {

/// Distances between two samples of the model itself, each as large as what was observed: the scale by which
/// observations count. Forty scars count less than four hundred.
struct SelfDistance {
    std::vector<double> medians;  ///< of each observation, above 0
    double at_90 = 0.0;           ///< of all together: 90 % of such samples are nearer
    double at_95 = 0.0;

    /// All distances in one: the mean of each by its median.
    [[nodiscard]] double together(const std::vector<double>& distances) const;
};

/// How much was observed, 0: it counts nothing; and of what. Views of the same rocks are drawn together:
/// they agree by chance, and do not tell twice as much.
struct Witnessed {
    std::size_t points = 0;
    std::uint32_t witness = 0;
    double least_scale = 0.0;  ///< Observation::least_scale
};

/// `sets`: simulated samples of one parameter set, by set, by observation, as `observed`. Draws by `seed` and
/// `wave`.
SelfDistance self_distance(const std::vector<std::vector<Sample>>& sets,
                           const std::vector<Witnessed>& observed, std::uint64_t seed, std::uint16_t wave);

/// So many points of several samples together, but not of that of number `without`, by chance and without
/// repetition as far as there are enough.
Sample drawn_from(const std::vector<const Sample*>& samples, std::size_t without, std::size_t points,
                  const std::function<double()>& uniform);

}  // namespace coupling::calibrate
