#pragma once

#include "config/options/options.hpp"
#include "forest/disturbance/disturbance.hpp"
#include "forest/mortality.hpp"
#include "forest/regeneration/regeneration.hpp"
#include "forest/wounds.hpp"

namespace forest {

/// Which processes of a year run, beside those that always do.
struct Processes {
    bool self_thinning = true;
    bool regeneration = true;
    bool co2_response = false;  ///< of quantum efficiency and conductance; off: as at 350 ppm
};

/// All forest settings that a user can change, with their defaults.
struct Parameters {
    MortalityLaw mortality;
    RegenerationLaw regeneration;
    UprootingLaw uprooting;  ///< by rocks
    DisturbanceLaw disturbance;
    Processes processes;
};

/// Declares the settings [forest] and [disturbance].
void declare(config::Options& options, Parameters& parameters);

}  // namespace forest
