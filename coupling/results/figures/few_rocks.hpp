#pragma once

#include <cstdint>
#include <string>

#include "coupling/results/figures/indicators.hpp"

namespace coupling {

// The one rule for protection effects of few rocks: the pages of all kinds of runs, `compare`, hazard maps
// and the terminal ask it.

/// From so many arrivals over the bare slope on a protection effect is reported [choice]: that of a handful
/// lies anywhere. protection.csv holds the value in any case, with `too_few_rocks` beside it.
inline constexpr std::uint64_t least_arrivals_for_protection = 5;

inline bool too_few_for_protection(std::uint64_t bare_arrivals) {
    return bare_arrivals < least_arrivals_for_protection;
}

/// Whether an interval of a protection effect, or of a difference between two, says nothing [choice]: it
/// holds 0 and reaches beyond 100 % on a side. Such are those of few rocks.
inline bool says_nothing(double low_percent, double high_percent) {
    return low_percent <= 0.0 && high_percent >= 0.0 && (low_percent < -100.0 || high_percent > 100.0);
}

/// The same where the interval of the effect is known: also if it says nothing.
bool too_few_for_protection(const PairedCounts& counts);

/// "only 2 rocks arrive over the bare slope: too few for a protection figure". Text, not markup.
std::string too_few_in_words(std::uint64_t bare_arrivals);

}  // namespace coupling
