#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/decades/tables/band.hpp"
#include "coupling/assessments/decades/tables/comparison.hpp"
#include "coupling/results/report/chart.hpp"

namespace coupling::decades {

/// Bands of more regimes would hide each other.
inline constexpr std::size_t most_bands = 4;

/// A figure of one course over the years.
struct RegimeCurve {
    std::size_t line = 0;     ///< its style
    std::size_t climate = 0;  ///< place among the climates
    std::string name;         ///< in the legend
    std::string letter;       ///< at the end of the line; empty for none
    std::vector<report::ChartPoint> means{};
    std::vector<report::ChartRange> ranges{};  ///< of the mean; empty without a band
};

/// The 90 % interval of the mean; of no width where it is not known.
report::ChartRange range_at(double x, const Band& band);

/// What the charts of a figure share.
struct RegimeAxes {
    std::string title;
    std::string y_title;
    std::size_t years = 0;                   ///< from year 0 on
    std::vector<std::string> climates = {};  ///< a chart for each of them; empty: one for all curves
    bool may_begin_above_0 = false;          ///< percents, see percent_axis
};

/// A line for each course, with a band where a chart has ranges and at most four lines. Charts of several
/// climates have the same scale. `caption` is HTML.
std::string regime_charts(const RegimeAxes& axes, std::span<const RegimeCurve> curves,
                          const std::string& caption);

/// The same of a figure of all members: means over replicates with their ranges. A line cannot leave the
/// chart downwards: below 0 it is drawn at 0. Years and climates of `axes` are those of the figure. Requires
/// a year.
std::string series_charts(const Names& names, const Series& series, RegimeAxes axes,
                          const std::string& caption);

}  // namespace coupling::decades
