#pragma once

#include "config/options/options.hpp"
#include "forest/deaths/mortality.hpp"
#include "forest/deaths/wounds.hpp"
#include "forest/disturbance/disturbance.hpp"
#include "forest/production/tree_differences.hpp"
#include "forest/regeneration/regeneration.hpp"
#include "forest/site/processes.hpp"

namespace forest {

/// All forest settings that a user can change, with their defaults.
struct Parameters {
    MortalityLaw mortality;
    RegenerationLaw regeneration;
    UprootingLaw uprooting;  ///< by rocks
    DisturbanceLaw disturbance;
    TreeDifferences differences;
    Processes processes;
};

/// Declares the settings [forest] and [disturbance].
void declare(config::Options& options, Parameters& parameters);

}  // namespace forest
