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
inline bool too_few_for_protection(const PairedCounts& counts) {
    return too_few_for_protection(counts.bare());
}

/// "only 2 rocks arrive over the bare slope: too few for a protection figure". Text, not markup.
std::string too_few_in_words(std::uint64_t bare_arrivals);

}  // namespace coupling
