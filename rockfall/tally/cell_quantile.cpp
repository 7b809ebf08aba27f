#include "rockfall/tally/cell_quantile.hpp"

#include <algorithm>
#include <cmath>

namespace rockfall {

double cell_quantile(const LogBins& bins, std::span<const std::uint32_t> counts, std::uint64_t total,
                     float largest, double share) {
    if (counts.empty()) {
        return 0.0;
    }
    const double wanted = share * static_cast<double>(total);
    const auto at_least =
        static_cast<std::uint64_t>(std::ceil(wanted));  // whole counts below it lie below wanted
    std::uint64_t below = total;
    std::size_t bin = std::min(bins.bin_of(largest), counts.size() - 1) + 1;
    while (bin > 0 && below >= at_least) {
        below -= counts[--bin];
    }
    if (below >= at_least) {
        return 0.0;  // no counts
    }
    return bins.low_of(bin) + (wanted - static_cast<double>(below)) / static_cast<double>(counts[bin]) *
                                  (bins.high_of(bin) - bins.low_of(bin));
}

}  // namespace rockfall
