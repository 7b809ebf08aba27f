#pragma once

#include <cstdint>

#include "config/random/stream.hpp"

namespace coupling::calibrate {

/// Random numbers of a search. Draws of runs have the year 0 (inputs/parameters): waves begin at 1.
enum class Choice : std::uint64_t {
    spread = 1,
    hold_out = 2,
    first_rock = 3,
    proposal = 4,
    trial = 5,
    summary = 6
};

/// Kinds of rocks or scars that are seen, at most, where an item has a stream for each.
inline constexpr std::uint64_t most_witnesses = 4096;

/// Of one `item` of a wave: a set, an observation, a trial.
inline config::RandomStream choices(std::uint64_t seed, std::uint16_t wave, Choice choice,
                                    std::uint64_t item) {
    constexpr std::uint64_t choices_of_item = 8;
    return config::RandomStream{{seed, 0, static_cast<std::uint16_t>(wave + 1),
                                 choices_of_item * item + static_cast<std::uint64_t>(choice)},
                                config::Purpose::parameter};
}

}  // namespace coupling::calibrate
