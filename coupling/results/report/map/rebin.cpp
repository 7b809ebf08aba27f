#include "coupling/results/report/map/rebin.hpp"

#include <algorithm>
#include <numeric>

namespace coupling::report {

std::vector<double> rebinned(const rockfall::LogBins& bins, std::span<const std::uint64_t> counts,
                             double per_unit, std::span<const double> edges) {
    const std::size_t bars = edges.size() - 1;
    std::vector<double> sums(bars, 0.0);
    for (std::size_t bin = 0; bin < counts.size(); ++bin) {
        if (counts[bin] == 0) {
            continue;
        }
        const double low = bins.low_of(bin) / per_unit;
        const double high = bins.high_of(bin) / per_unit;
        const auto count = static_cast<double>(counts[bin]);
        for (std::size_t bar = 0; bar < bars; ++bar) {
            const double from = bar == 0 ? low : std::max(low, edges[bar]);
            const double to = bar + 1 == bars ? high : std::min(high, edges[bar + 1]);
            sums[bar] += count * std::max(0.0, to - from) / (high - low);
        }
    }
    return sums;
}

std::vector<std::pair<double, double>> exceeded(const rockfall::LogBins& bins,
                                                std::span<const std::uint64_t> counts) {
    std::vector<std::pair<double, double>> curve;
    auto above = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
    for (std::size_t bin = 0; bin < counts.size(); ++bin) {
        if (counts[bin] == 0) {
            continue;
        }
        if (curve.empty() || curve.back().first != bins.low_of(bin)) {
            curve.emplace_back(bins.low_of(bin), above);
        }
        above -= static_cast<double>(counts[bin]);
        curve.emplace_back(bins.high_of(bin), above);
    }
    return curve;
}

}  // namespace coupling::report
