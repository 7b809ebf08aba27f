#include "coupling/assessments/nets/figures/net_quantiles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coupling {
namespace {

/// How many of `count` a share is, at least 1.
std::size_t rank_of(double share, std::size_t count) {
    // A hair less, so that 0.95 of 100 is 95 although 0.95 is a little more than that.
    const double wanted = std::ceil(share * static_cast<double>(count) - 1e-9);
    return std::clamp<std::size_t>(static_cast<std::size_t>(std::max(1.0, wanted)), 1, count);
}

}  // namespace

QuantileEstimate quantile_of(std::span<const double> sorted, double share) {
    QuantileEstimate estimate;
    estimate.value = sorted[rank_of(share, sorted.size()) - 1];
    const Ranks ranks = quantile_ranks(sorted.size(), share);
    estimate.interval.low = ranks.low > 0 ? sorted[ranks.low - 1] : std::numeric_limits<double>::quiet_NaN();
    if (ranks.high <= sorted.size()) {
        estimate.interval.high = sorted[ranks.high - 1];
    }
    return estimate;
}

std::uint64_t rocks_to_tell(double wanted_share) {
    // A hair less, so that 0.95 asks for 20 although 1 - 0.95 is a little less than a twentieth.
    return static_cast<std::uint64_t>(std::ceil(1.0 / (1.0 - wanted_share) - 1e-6));
}

}  // namespace coupling
