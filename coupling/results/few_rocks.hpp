#pragma once

#include <cstdint>

#include "coupling/results/indicators.hpp"

namespace coupling {

/// From so many arrivals over the bare slope on a protection effect is told in words [choice]: that of a
/// handful lies anywhere. Tables hold it in any case.
inline constexpr std::uint64_t least_arrivals_to_tell = 5;

inline bool too_few_to_tell(const PairedCounts& counts) {
    return counts.bare() < least_arrivals_to_tell;
}

}  // namespace coupling
