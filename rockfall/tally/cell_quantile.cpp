#include "rockfall/tally/cell_quantile.hpp"

#include <algorithm>

namespace rockfall {

double cell_quantile(const LogBins& bins, std::span<const std::uint32_t> counts, std::uint64_t total,
                     float largest, double share) {
    if (counts.empty()) {
        return 0.0;
    }
    const double wanted = share * static_cast<double>(total);
    std::uint64_t up_to = total;  // counts in this bin and below it: not less than wanted
    for (std::size_t bin = std::min(bins.bin_of(largest), counts.size() - 1) + 1; bin-- > 0;) {
        const auto below = static_cast<double>(up_to - counts[bin]);
        if (counts[bin] > 0 && below < wanted) {
            return bins.low_of(bin) + (wanted - below) / static_cast<double>(counts[bin]) *
                                          (bins.high_of(bin) - bins.low_of(bin));
        }
        up_to -= counts[bin];
    }
    return 0.0;
}

}  // namespace rockfall
