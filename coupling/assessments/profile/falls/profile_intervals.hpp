#pragma once

#include <optional>
#include <vector>

#include "coupling/assessments/profile/falls/profile_tally.hpp"
#include "coupling/inputs/parameters/parameter_draws.hpp"
#include "coupling/results/figures/drawn_figure.hpp"

namespace coupling::profile {

/// What is drawn for the strata of so many rocks along a profile. Where run.parameter_draws is off, the
/// central values: empty without a joint sample.
ParameterDraws draws_on(const Scenario& scenario, const ProfileSite& site, std::uint64_t rocks);

/// Main figures with both intervals: of the rocks alone, and of all that is not known.
struct ProfileIntervals {
    struct AtStation {
        std::optional<DrawnFigure> share;  ///< of all rocks [0, 1]
        std::optional<DrawnFigure> energy_mean_kj;
        std::optional<DrawnFigure> energy_95_kj;
        std::optional<DrawnFigure> speed_mean_mps;
        std::optional<DrawnFigure> height_95_m;
    };
    std::optional<DrawnFigure> run_out_mean_m;  ///< of those that came to rest
    std::vector<AtStation> stations;
};

/// Nothing where all rocks fell by the same laws. A percentile is taken to change as the mean does [choice].
std::optional<ProfileIntervals> intervals_of(const ProfileTally& tally, const ParameterDraws& draws);

}  // namespace coupling::profile
