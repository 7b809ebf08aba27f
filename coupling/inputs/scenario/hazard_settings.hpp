#pragma once

#include <cstdint>
#include <string>

namespace coupling {

/// Which energy of the rocks in a cell is the intensity there.
enum class HazardEnergy : std::uint8_t { mean, p50, p90, p95, p98, p99, max };

/// How energy and frequency of rocks give a level: README.md of the hazard room has each rule with its
/// source.
enum class HazardRule : std::uint8_t {
    cadanav,  ///< return period at the place of rocks of each class of energy
    arrival,  ///< percentile of those that pass, return period of all that arrive
    release,  ///< percentile of those that pass, return period of the release
};

/// The settings of section [hazard].
struct HazardSettings {
    std::string blocks;                ///< CSV of block sizes by return period and zone; empty: none
    double return_period_years = 0.0;  ///< only this one of them; 0: all, and the hazard map from them
    HazardEnergy energy = HazardEnergy::p95;
    HazardRule rule = HazardRule::release;
    double least_reach_percent = 0.0;  ///< cells with a smaller reach probability are left out
    double smallest_zone_m2 = 400.0;   ///< smaller zones are part of what is around them
    std::string matrix;                ///< CSV of hazard levels; empty: the shipped one
};

}  // namespace coupling
