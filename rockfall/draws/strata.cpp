#include "rockfall/draws/strata.hpp"

#include <bit>
#include <cassert>

#include "config/random/stream.hpp"

namespace rockfall {

std::uint32_t strata_for(std::uint64_t rocks) {
    constexpr std::uint32_t most = 64;
    constexpr std::uint32_t least = 16;
    constexpr std::uint64_t least_rocks = 16;
    std::uint32_t strata = most;
    while (strata > least && rocks < least_rocks * strata) {
        strata /= 2;
    }
    return strata;
}

std::uint32_t stratum_of(std::uint64_t rock, std::uint32_t strata, std::uint64_t seed) {
    assert(std::has_single_bit(strata));
    const std::uint64_t group = rock / strata;
    const auto place = static_cast<std::uint32_t>(rock % strata);
    const config::RandomStream stream{{seed, 0, 0, group}, config::Purpose::rock_stratum};
    const config::FourUniforms u = stream.uniforms_of(0);
    const double count = strata;
    // place -> odd * place + shift is a permutation where the number of strata is a power of two.
    const std::uint32_t odd = 2 * static_cast<std::uint32_t>(u[0] * count) + 1;
    const auto shift = static_cast<std::uint32_t>(u[1] * count);
    return (odd * place + shift) & (strata - 1);
}

}  // namespace rockfall
