#pragma once

#include <cstdint>
#include <span>

#include "coupling/results/figures/indicators.hpp"

namespace coupling {

/// A quantile as an order statistic: the smallest value that at least the share of all does not exceed. Its
/// interval lies between two order statistics. Requires values in order, not empty.
QuantileEstimate quantile_of(std::span<const double> sorted, double share);

/// So many rocks must reach a net before it can be said what holds a share of them: one that may pass.
std::uint64_t rocks_to_tell(double wanted_share);

}  // namespace coupling
