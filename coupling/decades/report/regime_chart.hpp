#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "coupling/results/report/chart.hpp"

namespace coupling::decades {

/// Bands of more regimes would hide each other.
inline constexpr std::size_t most_bands = 4;

/// A figure of one regime over the years.
struct RegimeCurve {
    std::size_t regime = 0;  ///< place in the scenario's list: the style of the line
    std::string name;        ///< in the legend
    std::string letter;      ///< at the end of the line; empty for none
    std::vector<report::ChartPoint> means{};
    std::vector<report::ChartRange> ranges{};  ///< of the replicates; empty without a band
};

/// A line for each regime from year 0 to `years`, with a band where there are ranges and at most four
/// regimes. `caption` is HTML.
std::string regime_chart(const std::string& title, const std::string& y_title, std::size_t years,
                         std::span<const RegimeCurve> curves, const std::string& caption);

}  // namespace coupling::decades
