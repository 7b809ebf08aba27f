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
    std::vector<std::uint32_t> sites{};  ///< of each observation, rising; empty: one site
    std::vector<double> of_sites{};      ///< with several: what 90 % of such samples stay below, at each

    /// All distances in one: the mean of each by its median. Of several sites the largest of these means,
    /// each by the 90 % point of its site: none pays for another.
    [[nodiscard]] double together(const std::vector<double>& distances) const;
    /// The mean at one site; infinite where nothing counts there.
    [[nodiscard]] double at_site(const std::vector<double>& distances, std::uint32_t site) const;
};

/// How much was observed, 0: it counts nothing; and of what. Views of the same rocks are drawn together:
/// they agree by chance, and do not tell twice as much.
struct Witnessed {
    std::size_t points = 0;
    std::uint32_t witness = 0;
    double least_scale = 0.0;  ///< Observation::least_scale
    std::uint32_t site = 0;
};

/// Sites of observations; none where all are of one.
std::vector<std::uint32_t> sites_of(const std::vector<Witnessed>& observed);

/// Scales each site by what 90 % of the trials stay below there. Requires medians.
void scale_sites(SelfDistance& scale, const std::vector<std::vector<double>>& trials);

/// `sets`: simulated samples of one parameter set, by set, by observation, as `observed`. Draws by `seed` and
/// `wave`.
SelfDistance self_distance(const std::vector<std::vector<Sample>>& sets,
                           const std::vector<Witnessed>& observed, std::uint64_t seed, std::uint16_t wave);

/// So many points of several samples together, but not of that of number `without`, by chance and without
/// repetition as far as there are enough.
Sample drawn_from(const std::vector<const Sample*>& samples, std::size_t without, std::size_t points,
                  const std::function<double()>& uniform);

}  // namespace coupling::calibrate
