#include "coupling/results/figures/indicators.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "config/random/quantiles.hpp"

namespace coupling {
namespace {

constexpr double tail = 0.025;
constexpr double one_sided_tail = 0.05;
constexpr double normal_quantile_975 = 1.959963984540054;

Interval clopper_pearson(std::uint64_t part, std::uint64_t whole) {
    if (whole == 0) {
        return {0.0, 1.0};
    }
    const auto trials = static_cast<double>(whole);
    const auto hits = static_cast<double>(part);
    return {config::least_probability(trials, hits, tail), config::greatest_probability(trials, hits, tail)};
}

}  // namespace

Share share_of(std::uint64_t part, std::uint64_t whole) {
    assert(part <= whole);
    const double value = whole == 0 ? std::numeric_limits<double>::quiet_NaN()
                                    : static_cast<double>(part) / static_cast<double>(whole);
    return {part, whole, value, clopper_pearson(part, whole)};
}

double greatest_share_of_none(std::uint64_t whole) {
    return whole == 0 ? 1.0 : 1.0 - std::pow(one_sided_tail, 1.0 / static_cast<double>(whole));
}

std::optional<ProtectionEffect> protection_effect(const PairedCounts& counts) {
    const auto bare = static_cast<double>(counts.bare());
    const auto forest = static_cast<double>(counts.forest());
    if (counts.bare() == 0) {
        return std::nullopt;
    }
    if (counts.forest() == 0) {
        return ProtectionEffect{1.0, {2.0 - std::pow(one_sided_tail, -1.0 / bare), 1.0}, true};
    }
    const double ratio = forest / bare;
    const double changed = static_cast<double>(counts.only_bare) + static_cast<double>(counts.only_forest);
    if (changed == 0.0) {
        const double may_change = 1.0 - std::pow(tail, 1.0 / bare);
        return ProtectionEffect{0.0, {-may_change, may_change}, false};
    }
    const double half_width = normal_quantile_975 * std::sqrt(changed / (bare * forest));
    return ProtectionEffect{
        1.0 - ratio, {1.0 - ratio * std::exp(half_width), 1.0 - ratio * std::exp(-half_width)}, false};
}

Ranks quantile_ranks(std::uint64_t count, double share) {
    if (count == 0) {
        return {0, 1};
    }
    const auto trials = static_cast<double>(count);
    // P(B < low) <= 2.5 % and P(B >= high) <= 2.5 %, where B of the values lie below the quantile.
    auto low = static_cast<std::uint64_t>(config::binomial_count(trials, share, tail));
    auto high = static_cast<std::uint64_t>(config::binomial_count(trials, share, 1.0 - tail));
    while (low > 0 && config::chance_of_at_most(static_cast<double>(low - 1), trials, share) > tail) {
        --low;
    }
    while (config::chance_of_at_most(static_cast<double>(low), trials, share) <= tail) {
        ++low;
    }
    high = std::max<std::uint64_t>(high, 1);
    while (high <= count &&
           config::chance_of_more_than(static_cast<double>(high - 1), trials, share) > tail) {
        ++high;
    }
    return {low, high};
}

std::vector<rockfall::BinCounts::Filled> filled_bins(std::span<const std::uint64_t> counts) {
    std::vector<rockfall::BinCounts::Filled> filled;
    for (std::size_t bin = 0; bin < counts.size(); ++bin) {
        if (counts[bin] > 0) {
            filled.push_back({bin, counts[bin]});
        }
    }
    return filled;
}

std::uint64_t sum_of(std::span<const rockfall::BinCounts::Filled> filled) {
    std::uint64_t sum = 0;
    for (const rockfall::BinCounts::Filled& here : filled) {
        sum += here.count;
    }
    return sum;
}

double quantile_of(const rockfall::LogBins& bins, std::span<const rockfall::BinCounts::Filled> filled,
                   double share) {
    const double wanted = share * static_cast<double>(sum_of(filled));
    double below = 0.0;
    for (const rockfall::BinCounts::Filled& one : filled) {
        const auto here = static_cast<double>(one.count);
        if (below + here >= wanted) {
            const double low = bins.low_of(one.bin);
            return low + (wanted - below) / here * (bins.high_of(one.bin) - low);
        }
        below += here;
    }
    return 0.0;
}

QuantileEstimate quantile_estimate(const rockfall::LogBins& bins, std::span<const std::uint64_t> counts,
                                   double share, double largest) {
    return quantile_estimate(bins, filled_bins(counts), share, largest);
}

QuantileEstimate quantile_estimate(const rockfall::LogBins& bins,
                                   std::span<const rockfall::BinCounts::Filled> filled, double share,
                                   double largest) {
    const std::uint64_t total = sum_of(filled);
    QuantileEstimate estimate;
    if (total == 0) {
        return estimate;
    }
    estimate.value = std::min(quantile_of(bins, filled, share), largest);

    const Ranks ranks = quantile_ranks(total, share);
    estimate.interval.low = std::numeric_limits<double>::quiet_NaN();
    std::uint64_t rank = 0;
    for (const rockfall::BinCounts::Filled& here : filled) {
        const std::uint64_t before = rank;
        rank += here.count;
        if (before < ranks.low && ranks.low <= rank) {
            estimate.interval.low = std::min(bins.low_of(here.bin), largest);
        }
        if (before < ranks.high && ranks.high <= rank) {
            const bool is_last = here.bin + 1 == bins.count();
            estimate.interval.high = is_last ? largest : std::min(bins.high_of(here.bin), largest);
        }
    }
    return estimate;
}

std::uint64_t rocks_for_width(std::uint64_t rocks, double present_width, double wanted_width) {
    assert(wanted_width > 0.0);
    const double factor = present_width / wanted_width;
    return static_cast<std::uint64_t>(std::ceil(static_cast<double>(rocks) * factor * factor));
}

std::optional<RiskReduction> risk_reduction(const PairedCounts& counts, double energy_95_forest,
                                            double energy_95_bare) {
    if (counts.bare() == 0 || energy_95_bare <= 0.0) {
        return std::nullopt;
    }
    const double frequency_left = static_cast<double>(counts.forest()) / static_cast<double>(counts.bare());
    const double energy_95_left = counts.forest() == 0 ? 0.0 : energy_95_forest;
    const double intensity_left = energy_95_left / energy_95_bare;
    return RiskReduction{100.0 * (1.0 - frequency_left), 100.0 * (1.0 - intensity_left),
                         100.0 * (1.0 - frequency_left * intensity_left)};
}

}  // namespace coupling
