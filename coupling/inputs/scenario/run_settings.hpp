#pragma once

#include <cstdint>

namespace coupling {

/// The settings of section [run] for any kind of run.
struct RunSettings {
    std::uint64_t seed = 1;
    std::uint64_t years = 0;     ///< 0: static assessment of the given stand
    bool strict_inputs = false;  ///< what is only doubtful becomes an error
    std::uint64_t rocks_per_part =
        250'000;  ///< of a static run: so many rocks later its state is saved again
};

}  // namespace coupling
