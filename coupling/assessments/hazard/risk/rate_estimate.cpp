#include "coupling/assessments/hazard/risk/rate_estimate.hpp"

#include <cmath>

#include "config/random/quantiles.hpp"

namespace coupling::hazard::risk {
namespace {

constexpr double tail = 0.025;

}  // namespace

Estimate estimate(const RateSum& rate) {
    Estimate found{rate.sum, 0.0, 0.0};
    if (rate.sum > 0.0) {
        const double scale = rate.squares / rate.sum;
        found.low = scale * config::gamma_quantile(rate.sum / scale, tail);
    }
    const double one_more = rate.sum + rate.largest;
    if (one_more > 0.0) {
        const double scale = (rate.squares + rate.largest * rate.largest) / one_more;
        found.high = scale * config::gamma_quantile(one_more / scale, 1.0 - tail);
    }
    return found;
}

Estimate difference(const RateSum& more, const RateSum& less) {
    const Estimate a = estimate(more);
    const Estimate b = estimate(less);
    const double value = a.value - b.value;
    return {value, value - std::hypot(a.value - a.low, b.high - b.value),
            value + std::hypot(a.high - a.value, b.value - b.low)};
}

}  // namespace coupling::hazard::risk
