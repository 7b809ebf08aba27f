#pragma once

#include <cstdint>

namespace rockfall {

/// The strata among which the rocks of an ensemble are shared, each with a draw of its own of what is not
/// known: the largest power of two up to 64 that leaves each at least 16 rocks; at least 16 strata.
///
/// [choice] 64 draws give the ends of a 95 % interval; fewer rocks than 1024 make do with fewer draws.
std::uint32_t strata_for(std::uint64_t rocks);

/// The stratum of a rock: a function of its number alone. Of each `strata` rocks that follow one another each
/// is in a stratum of its own; which one changes at random from one such group to the next, so that strata do
/// not go with places. Requires a power of two.
std::uint32_t stratum_of(std::uint64_t rock, std::uint32_t strata, std::uint64_t seed);

/// The strata of a finished ensemble.
struct Strata {
    std::uint32_t count = 1;  ///< 1: all rocks fell by the same values
    std::uint64_t seed = 0;
    [[nodiscard]] std::uint32_t of(std::uint64_t rock) const {
        return count > 1 ? stratum_of(rock, count, seed) : 0;
    }
};

}  // namespace rockfall
