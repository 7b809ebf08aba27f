#pragma once

#include "coupling/inputs/scenario/scenario.hpp"
#include "rockfall/release/release.hpp"

namespace coupling {

/// What no single setting shows: inputs that are missing or exclude each other, lists that do not match.
/// Throws InputError (settings) with all of it.
void check(const Scenario& scenario);

/// The law of rock sizes that the scenario asks for. Requires a checked scenario.
rockfall::DiameterLaw diameter_law(const Scenario& scenario);

}  // namespace coupling
