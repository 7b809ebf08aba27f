#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "config/random/stream.hpp"

namespace config {

/// Points that cover the unit cube evenly: by point, by dimension, on [0, 1).
///
/// A Latin hypercube (McKay, Beckman & Conover 1979): in each dimension one point lies in each of `points`
/// equal stretches, anywhere in it. Of 32 random orders each dimension takes the one whose ranks correlate
/// least with those of the dimensions before it. The numbers of a dimension are keyed by its identity
/// (`dimensions`, below 2^48), so a further one at the end changes no other.
std::vector<std::vector<double>> latin_hypercube(const StreamKey& key, Purpose purpose,
                                                 std::span<const std::uint64_t> dimensions,
                                                 std::size_t points);

}  // namespace config
