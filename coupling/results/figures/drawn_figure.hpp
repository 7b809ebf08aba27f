#pragma once

#include <array>
#include <optional>
#include <vector>

#include "coupling/results/figures/indicators.hpp"
#include "rockfall/tally/ensemble_tally.hpp"

namespace coupling {

/// A figure with its two 95 % intervals: by the chance of the rocks alone, and by all that is not known. A
/// lower end is NaN where it is not known.
struct DrawnFigure {
    double value = 0.0;
    Interval of_rocks;
    Interval of_all;
    std::vector<double> shares;  ///< of what draws bring, by component of the draws; together at most 1

    /// Whether draws show more spread than the chance of the rocks could hide: else the second interval holds
    /// what it could (parameter_spread).
    bool has_spread = true;
};

/// What arrives at a target on one slope; nothing where too few strata have rocks that arrive.
struct DrawnArrivals {
    std::optional<DrawnFigure> share;  ///< of all rocks [0, 1]
    std::optional<DrawnFigure> energy_mean_kj;
    std::optional<DrawnFigure> energy_95_kj;
    std::optional<DrawnFigure> height_95_m;
};

struct DrawnTarget {
    std::array<DrawnArrivals, rockfall::covers> by_cover;
    std::optional<DrawnFigure> protection;  ///< as ProtectionEffect

    /// The figure whose causes are named beside share and protection: the protection, where draws show its
    /// spread, else the share.
    [[nodiscard]] const std::optional<DrawnFigure>& leading(rockfall::Cover cover) const {
        const std::optional<DrawnFigure>& share = by_cover[static_cast<std::size_t>(cover)].share;
        return protection && (protection->has_spread || !share) ? protection : share;
    }
    /// Whether draws show no spread of one of the two.
    [[nodiscard]] bool has_hidden_spread(rockfall::Cover cover) const {
        const std::optional<DrawnFigure>& share = by_cover[static_cast<std::size_t>(cover)].share;
        return (share && !share->has_spread) || (protection && !protection->has_spread);
    }
};

/// Run-out of the rocks that came to rest.
struct DrawnRunOut {
    std::optional<DrawnFigure> mean_m;
    std::optional<DrawnFigure> p95_m;
};

/// The main figures of a run whose rocks drew what is not known by strata.
struct DrawnFigures {
    std::vector<DrawnTarget> targets;
    std::array<DrawnRunOut, rockfall::covers> run_outs;
};

}  // namespace coupling
