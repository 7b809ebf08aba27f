#pragma once

#include <span>
#include <vector>

#include "validation/engine/case/case_result.hpp"

namespace coupling::validation {

/// A figure estimated from series of rocks, each with its own rocks and its own stand, so that the scatter
/// between series holds the chance of both.
///
/// `pulls` says how far each series pulls the figure: its linearised residual, all summing up to 0. The
/// variance is S / (S - 1) times the sum of their squares, S the number of series (ratio estimator of
/// clusters: Cochran 1977, Sampling Techniques, Eqs. 6.9 and 11.30). Because pulls add up series by series,
/// differences of figures from the same rocks are paired comparisons.
struct SeriesEstimate {
    double value = 0.0;
    std::vector<double> pulls;

    /// 95 %: value ± t(0.975, S - 1) standard errors; unbounded for fewer than two series.
    [[nodiscard]] Estimate interval() const;
};

/// r = sum of numerators / sum of denominators; pulls (x_i - r y_i) / sum of y. NaN without a denominator.
/// Requires as many numerators as denominators.
SeriesEstimate ratio_of(std::span<const double> numerators, std::span<const double> denominators);

/// The mean of figures from the same series. Requires at least one.
SeriesEstimate mean_of(std::span<const SeriesEstimate> figures);

/// a - b, from the same series.
SeriesEstimate difference(const SeriesEstimate& a, const SeriesEstimate& b);

/// 1 - figure.
SeriesEstimate one_minus(SeriesEstimate figure);

}  // namespace coupling::validation
