#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "rockfall/tally/log_bins.hpp"

namespace coupling::report {

/// Counts of fine bins in the wider bars of a chart. A fine bin that an edge cuts is shared by length; the
/// first bar takes all below, the last all above. `per_unit`: counted units in one unit of the edges.
std::vector<double> rebinned(const rockfall::LogBins& bins, std::span<const std::uint64_t> counts,
                             double per_unit, std::span<const double> edges);

/// How many values lie above each limit of the bins, from the lower limit of the first filled bin to the
/// upper one of the last: (value, count) where the count changes.
std::vector<std::pair<double, double>> exceeded(const rockfall::LogBins& bins,
                                                std::span<const std::uint64_t> counts);

}  // namespace coupling::report
