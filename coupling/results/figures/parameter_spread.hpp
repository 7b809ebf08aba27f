#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "coupling/results/figures/indicators.hpp"

namespace coupling {

/// A figure in one stratum of rocks, whose rocks share a draw of what is not known.
struct StratumFigure {
    double value = 0.0;
    double chance = 0.0;      ///< variance by the chance of its rocks alone; above 0
    std::size_t stratum = 0;  ///< place among the draws
};

/// How far a figure spreads because of what is not known, without the chance of rocks.
struct ParameterSpread {
    double variance = 0.0;  ///< over the draws, as estimated
    Interval offsets;       ///< 95 % of the draws lie between mean + low and mean + high: low <= 0 <= high
    bool is_shown = true;   ///< else `offsets` are of what chance could hide, which is more
    std::vector<double> shares;  ///< of the variance, by component of the draws; together at most 1
};

/// Fewer strata with figures say nothing of a spread [choice].
inline constexpr std::size_t least_strata = 10;

/// A random-effects estimate: values over strata scatter by what was drawn and by the chance of the rocks of
/// each. Nothing with fewer than `least_strata` figures.
///
/// - variance: by moments with weights (DerSimonian & Laird 1986), floor 0.
/// - offsets: values are drawn towards their mean (each by sqrt(t / (t + chance)), t the variance), then 2.5
///   and 97.5 % are read off (position p (n + 1)). Estimates below what
///   chance could hide, one and a half standard errors of the estimate where nothing spreads [choice], count
///   as that: with the estimate alone 95 % intervals hold 82 % of new draws where chance is ten times the
///   spread.
/// - shares: of a linear regression of the values on the components of the draws, weighted, each squared
///   slope less its own variance. What is left is curved or joint.
///
/// `draws`: by stratum, by component, values of unit variance.
std::optional<ParameterSpread> parameter_spread(std::span<const StratumFigure> figures,
                                                std::span<const std::vector<double>> draws);

/// The 95 % interval of a figure by both causes: their half widths in squares on each side.
Interval by_both(double value, const Interval& of_rocks, const ParameterSpread& spread);

}  // namespace coupling
