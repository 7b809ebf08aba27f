#pragma once

#include <cstdint>
#include <span>

#include "rockfall/tally/log_bins.hpp"

namespace rockfall {

/// `quantile` of the counts of a cell, the same to the last bit, for the millions that maps ask for.
///
/// Starts from the bin of the largest value and goes down, so that the high percentiles of maps look at few
/// bins. Requires `total`, the sum of the counts, `largest`, whose bin is the last one that is filled, and
/// share in (0, 1].
double cell_quantile(const LogBins& bins, std::span<const std::uint32_t> counts, std::uint64_t total,
                     float largest, double share);

}  // namespace rockfall
