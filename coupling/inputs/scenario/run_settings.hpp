#pragma once

#include <cstdint>
#include <string>

namespace coupling {

/// The settings of section [run] for any kind of run.
struct RunSettings {
    std::uint64_t seed = 1;
    std::uint64_t years = 0;      ///< 0: static assessment of the given stand
    bool strict_inputs = false;   ///< what is only doubtful becomes an error
    bool parameter_draws = true;  ///< of a static run: what is not known is drawn for each stratum of rocks
    std::string drawing;          ///< GeoPackage that is drawn in: its empty layers count as not given
    std::string parameters;       ///< CSV that changes the widths of what is not known; empty: shipped ones
    std::uint64_t rocks_per_part =
        250'000;  ///< of a static run: so many rocks later its state is saved again
};

}  // namespace coupling
