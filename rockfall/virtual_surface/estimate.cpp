#include "rockfall/virtual_surface/estimate.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace rockfall {

SurfaceEstimate stop_probability(std::span<const ThrowTally> surfaces) {
    double throws = 0.0;
    double stopped = 0.0;
    for (const ThrowTally& tally : surfaces) {
        assert(tally.throws > 0 && tally.throws == surfaces.front().throws);
        throws += static_cast<double>(tally.throws);
        stopped += static_cast<double>(tally.stopped);
    }
    const double p = stopped / throws;
    double squares = 0.0;
    for (const ThrowTally& tally : surfaces) {
        const double off = static_cast<double>(tally.stopped) / static_cast<double>(tally.throws) - p;
        squares += off * off;
    }
    const auto count = static_cast<double>(surfaces.size());
    const double between = count > 1.0 ? squares / (count * (count - 1.0)) : 0.0;
    const double q = (stopped + 1.0) / (throws + 2.0);
    return {p, std::sqrt(std::max(between, q * (1.0 - q) / throws))};
}

SurfaceEstimate rolling_stops_per_m(std::span<const RollTally> surfaces) {
    double length_m = 0.0;
    double stopped = 0.0;
    for (const RollTally& tally : surfaces) {
        length_m += tally.length_m;
        stopped += static_cast<double>(tally.stopped);
    }
    assert(length_m > 0.0);
    const double rate = stopped / length_m;
    double squares = 0.0;
    for (const RollTally& tally : surfaces) {
        const double off = static_cast<double>(tally.stopped) - rate * tally.length_m;
        squares += off * off;
    }
    const auto count = static_cast<double>(surfaces.size());
    const double between = count > 1.0 ? count / (count - 1.0) * squares : 0.0;
    return {rate, std::sqrt(std::max(between, stopped + 1.0)) / length_m};
}

}  // namespace rockfall
