#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "rockfall/tally/bin_counts.hpp"
#include "rockfall/tally/log_bins.hpp"

namespace coupling {

/// A 95 % confidence interval. It covers the chance of the simulated rocks alone, not what inputs or model
/// get wrong.
struct Interval {
    double low = 0.0;
    double high = 0.0;
    [[nodiscard]] double width() const { return high - low; }
};

/// A part of a number of rocks.
struct Share {
    std::uint64_t part = 0;
    std::uint64_t whole = 0;
    double value = 0.0;  ///< [0, 1]; NaN where whole is 0
    Interval interval;
};

/// Interval by Clopper & Pearson (1934), exact: it covers at least 95 % at any count. Requires part <= whole;
/// of nothing all is possible: [0, 1].
///
/// Rocks are shared among the sources in fixed numbers, which makes the true scatter smaller than this
/// interval says.
Share share_of(std::uint64_t part, std::uint64_t whole);

/// Where none of `whole` was seen, the share lies below this with 95 % confidence (one-sided):
/// 1 - 0.05^(1 / whole), for many about 3 / whole (rule of three). The upper end of a two-sided interval is
/// higher: it leaves 2.5 %. Of nothing all is possible: 1.
double greatest_share_of_none(std::uint64_t whole);

/// Rocks that reach a target, counted on the same rocks with forest and without.
struct PairedCounts {
    std::uint64_t both = 0;
    std::uint64_t only_forest = 0;
    std::uint64_t only_bare = 0;
    [[nodiscard]] std::uint64_t forest() const { return both + only_forest; }
    [[nodiscard]] std::uint64_t bare() const { return both + only_bare; }
};

/// Share of the rocks arriving over the bare slope that the forest stops: PE = 1 - N_forest / N_bare.
struct ProtectionEffect {
    double value = 0.0;  ///< (-inf, 1]; below 0 the forest lets more rocks arrive
    Interval interval;
    bool one_sided = false;  ///< no rock came through the forest: `interval.low` is a one-sided 95 % limit
};

/// Nothing if no rock arrives over the bare slope: then there is no danger that a forest could lower.
///
/// Both slopes see the same rocks, so the ratio is a paired one: var(ln(N_f / N_0)) = (b + c) / (N_0 N_f)
/// with b the rocks that arrive on the bare slope only and c those that arrive with forest only (delta method
/// on the four-fold table).
///
/// - N_f = 0: PE is 1. Given N_0 events against none, the ratio of the two rates lies below 0.05^(-1/N_0) - 1
/// with 95 %
///   confidence (exact for counts of rare events; 3/N_0 for many rocks, the rule of three); PE is above 1
///   minus that.
/// - b + c = 0: no rock changed its fate; up to a share of 1 - 0.025^(1/N_0) may, either way.
std::optional<ProtectionEffect> protection_effect(const PairedCounts& counts);

/// A quantile and its interval.
struct QuantileEstimate {
    double value = std::numeric_limits<double>::quiet_NaN();
    /// Low is NaN and high infinite where the sample is too small to know (the upper end of a 95th percentile
    /// needs 72 rocks). Of no values at all low is 0.
    Interval interval{0.0, std::numeric_limits<double>::infinity()};
};

/// Quantile of counts in logarithmic bins, never above `largest`, the exact maximum of the sample.
///
/// The interval lies between two order statistics whose ranks are quantiles of the binomial law of (count,
/// share); it takes their whole bins and so errs on the wide side.
QuantileEstimate quantile_estimate(const rockfall::LogBins& bins, std::span<const std::uint64_t> counts,
                                   double share, double largest);
/// The same of bins of which those that hold something are listed, in rising order.
QuantileEstimate quantile_estimate(const rockfall::LogBins& bins,
                                   std::span<const rockfall::BinCounts::Filled> filled, double share,
                                   double largest);

/// Value below which a share of the counts lies, straight inside its bin; 0 without counts.
double quantile_of(const rockfall::LogBins& bins, std::span<const rockfall::BinCounts::Filled> filled,
                   double share);

/// The bins that hold something, in rising order.
std::vector<rockfall::BinCounts::Filled> filled_bins(std::span<const std::uint64_t> counts);

std::uint64_t sum_of(std::span<const rockfall::BinCounts::Filled> filled);

/// A percentile above which fewer than one value lies is the largest value and not known: the 90th needs 10
/// values, the 95th 20, the 98th 50, the 99th 100.
constexpr bool percentile_is_known(std::uint64_t count, std::uint64_t percentile) {
    return count * (100 - percentile) >= 100;
}

/// Ranks (1 = smallest) of the order statistics around a quantile; 0 for low or count + 1 for high: there is
/// none.
struct Ranks {
    std::uint64_t low = 0;
    std::uint64_t high = 0;
};
Ranks quantile_ranks(std::uint64_t count, double share);

/// How many rocks bring an interval from its present width to a wanted one: widths shrink with the square
/// root of the number of rocks. Requires a wanted width above 0.
std::uint64_t rocks_for_width(std::uint64_t rocks, double present_width, double wanted_width);

/// Rocks that halve any interval that is not one-sided.
inline std::uint64_t rocks_for_half(std::uint64_t rocks) {
    return 4 * rocks;
}

/// Reduction of frequency, of intensity and of both in percent, named after Dupire et al. (2016, Ecol. Indic.
/// 67:98).
///
/// Their formulas are not at hand; choice: barrier BARI = 100 (1 - N_f / N_0), intensity MIRI = 100 (1 -
/// E95_f / E95_0), overall ORPI = 100 (1 - (1 - BARI / 100) (1 - MIRI / 100)).
struct RiskReduction {
    double bari_percent = 0.0;
    double miri_percent = 0.0;  ///< 100 where no rock comes through the forest; NaN: percentiles not known
    double orpi_percent = 0.0;  ///< NaN where MIRI is
};
/// A percentile that is not known is NaN. Nothing if no rock arrives over the bare slope.
std::optional<RiskReduction> risk_reduction(const PairedCounts& counts, double energy_95_forest,
                                            double energy_95_bare);

}  // namespace coupling
