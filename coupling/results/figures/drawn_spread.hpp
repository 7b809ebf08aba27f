#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "coupling/inputs/parameters/parameter_draws.hpp"
#include "coupling/results/figures/drawn_figure.hpp"
#include "coupling/results/figures/parameter_spread.hpp"
#include "rockfall/tally/bin_counts.hpp"

namespace coupling {

/// Values of single rocks: how many, their mean, and their squares around it.
struct StratumSample {
    double count = 0.0;
    double mean = 0.0;
    double squares = 0.0;
};

/// Values in bins; squares are those of the middles of their bins.
template <class Middle>
StratumSample sample_of_bins(const rockfall::BinCounts& counts, double sum, const Middle& middle_of) {
    StratumSample sample;
    double middles = 0.0;
    for (const auto& [bin, count] : counts.filled()) {
        sample.count += static_cast<double>(count);
        middles += static_cast<double>(count) * middle_of(bin);
    }
    if (sample.count == 0.0) {
        return sample;
    }
    sample.mean = sum / sample.count;
    for (const auto& [bin, count] : counts.filled()) {
        const double off = middle_of(bin) - middles / sample.count;
        sample.squares += static_cast<double>(count) * off * off;
    }
    return sample;
}

/// Whether a figure of so many rocks may have a second interval: three to each stratum. Of fewer, chance
/// hides a spread of half the value, and none found would be taken for none [choice].
bool can_show_spread(double rocks, std::size_t strata);

/// Whether so many strata speak for all: three quarters [choice]. Fewer would be those whose draws let many
/// rocks come, which resemble each other.
bool are_most(std::size_t strata_with_rocks, std::size_t strata);

/// Means of strata, `sample(k)` of the k-th; those of few rocks weigh less. Empty where nothing scatters.
std::vector<StratumFigure> means_of_strata(std::size_t strata,
                                           const std::function<StratumSample(std::size_t)>& sample);

/// The same relative to the mean, for a percentile that is taken to change with it [choice]: a percentile has
/// too few rocks in a stratum.
std::vector<StratumFigure> scaled(std::vector<StratumFigure> strata, double factor);

/// The 95 % interval of a mean by the chance of all rocks; strata bring 1 / chance each.
Interval interval_of_mean(double mean, const std::vector<StratumFigure>& strata);

/// Some of all rocks of a stratum.
struct StratumShare {
    std::uint64_t part = 0;
    std::uint64_t all = 0;
};

/// What a figure can be. Where it is always above `least`, as the energy of a rock is, an interval that
/// reaches so far down has no lower end that is known.
struct FigureLimits {
    double least = 0.0;
    double most = std::numeric_limits<double>::infinity();
    bool can_be_least = true;
};
/// Of what each moving rock has some of: energy, speed. A way may be 0, and a height.
inline constexpr FigureLimits above_nothing{.can_be_least = false};

/// Gives figures of a run their second interval, from what its strata of rocks show.
class DrawnSpread {
public:
    /// `with_obstacles`: whether components of stems and logs play a part.
    DrawnSpread(const ParameterDraws& draws, bool with_obstacles);
    /// Of so many strata whose draws are not given: what brings the spread is not known.
    explicit DrawnSpread(std::size_t strata) : unit_draws_(strata), components_{0} {}

    /// The figure over all rocks with both intervals, within the limits; a lower end that is not known is
    /// NaN. Nothing where the figure is not known or too few strata show it.
    [[nodiscard]] std::optional<DrawnFigure> figure(double value, const Interval& of_rocks,
                                                    const FigureLimits& limits,
                                                    const std::vector<StratumFigure>& strata) const;

    /// Of shares [0, 1]: the variance by chance is the same in all strata, whatever their shares are. Nothing
    /// where no rock counts, or all.
    [[nodiscard]] std::optional<DrawnFigure> share(const Share& pooled,
                                                   const std::vector<StratumShare>& strata) const;

private:
    std::vector<std::vector<double>> unit_draws_;  ///< by stratum, by component
    std::size_t components_;
};

}  // namespace coupling
