#include "coupling/results/figures/drawn_spread.hpp"

#include <algorithm>
#include <cmath>

#include "config/math/elementary.hpp"
#include "coupling/inputs/parameters/correlated_draws.hpp"

namespace coupling {
namespace {

constexpr double two_sided_95 = 1.959963984540054;

}  // namespace

bool can_show_spread(double rocks, std::size_t strata) {
    constexpr double least_rocks_of_stratum = 3.0;
    return rocks >= least_rocks_of_stratum * static_cast<double>(strata);
}

bool are_most(std::size_t strata_with_rocks, std::size_t strata) {
    constexpr double least_share = 0.75;
    return static_cast<double>(strata_with_rocks) >= least_share * static_cast<double>(strata);
}

std::vector<StratumFigure> means_of_strata(std::size_t strata,
                                           const std::function<StratumSample(std::size_t)>& sample) {
    std::vector<StratumFigure> figures;
    std::vector<double> counts;
    double squares = 0.0;
    double freedom = 0.0;
    for (std::size_t k = 0; k < strata; ++k) {
        const StratumSample of_stratum = sample(k);
        if (of_stratum.count > 0.0) {
            squares += of_stratum.squares;
            freedom += of_stratum.count - 1.0;
            figures.push_back({of_stratum.mean, 0.0, k});
            counts.push_back(of_stratum.count);
        }
    }
    double rocks = 0.0;
    for (const double count : counts) {
        rocks += count;
    }
    if (freedom < 1.0 || squares <= 0.0 || !can_show_spread(rocks, strata) ||
        !are_most(figures.size(), strata)) {
        return {};
    }
    for (std::size_t i = 0; i < figures.size(); ++i) {
        figures[i].chance = squares / freedom / counts[i];
    }
    return figures;
}

std::vector<StratumFigure> scaled(std::vector<StratumFigure> strata, double factor) {
    for (StratumFigure& one : strata) {
        one.value *= factor;
        one.chance *= factor * factor;
    }
    return strata;
}

Interval interval_of_mean(double mean, const std::vector<StratumFigure>& strata) {
    double information = 0.0;
    for (const StratumFigure& one : strata) {
        information += 1.0 / one.chance;
    }
    const double half = information > 0.0 ? two_sided_95 / std::sqrt(information) : 0.0;
    return {mean - half, mean + half};
}

DrawnSpread::DrawnSpread(const ParameterDraws& draws, bool with_obstacles)
    : components_{draws.components.size()} {
    // Independent numbers: shares of a variance say nothing where causes correlate.
    for (const std::vector<double>& of_stratum : draws.factors) {
        std::vector<double> unit;
        for (std::size_t i = 0; i < of_stratum.size(); ++i) {
            const ParameterDraws::Component& component = draws.components[i];
            if (with_obstacles || !component.of_obstacles) {  // the last ones are
                unit.push_back(config::ln_of(of_stratum[i]) / component.width);
            }
        }
        unit_draws_.push_back(independent_of(draws.components, unit));
    }
}

std::optional<DrawnFigure> DrawnSpread::figure(double value, const Interval& of_rocks,
                                               const FigureLimits& limits,
                                               const std::vector<StratumFigure>& strata) const {
    if (!std::isfinite(value)) {
        return std::nullopt;
    }
    auto spread = parameter_spread(strata, unit_draws_);
    if (!spread) {
        return std::nullopt;
    }
    spread->shares.resize(components_, 0.0);
    const Interval both = by_both(value, of_rocks, *spread);
    const auto lower_end = [&](double low) {
        const bool is_known = limits.can_be_least || low > limits.least;
        return is_known ? low : std::numeric_limits<double>::quiet_NaN();
    };
    return DrawnFigure{value,
                       {lower_end(of_rocks.low), of_rocks.high},
                       {lower_end(std::isnan(both.low) ? both.low : std::max(limits.least, both.low)),
                        std::min(limits.most, both.high)},
                       spread->shares,
                       spread->is_shown};
}

std::optional<DrawnFigure> DrawnSpread::share(const Share& pooled,
                                              const std::vector<StratumShare>& strata) const {
    if (!can_show_spread(static_cast<double>(pooled.part), strata.size())) {
        return std::nullopt;
    }
    std::vector<StratumFigure> figures;
    double chance = 0.0;
    for (std::size_t k = 0; k < strata.size(); ++k) {
        const auto rocks = static_cast<double>(strata[k].all);
        if (rocks < 2.0) {
            continue;
        }
        const double value = static_cast<double>(strata[k].part) / rocks;
        chance += value * (1.0 - value) / (rocks - 1.0);
        figures.push_back({value, 0.0, k});
    }
    if (chance <= 0.0) {
        return std::nullopt;
    }
    for (StratumFigure& one : figures) {
        one.chance = chance / static_cast<double>(figures.size());
    }
    return figure(pooled.value, pooled.interval, {.most = 1.0}, figures);
}

}  // namespace coupling
