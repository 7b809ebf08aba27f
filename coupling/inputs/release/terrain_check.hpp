#pragma once

#include "coupling/inputs/scenario/scenario.hpp"

namespace coupling {

/// Reads the heights of a scenario alone. Throws config::InputError where they make no terrain that could be
/// meant, for whatever rocks.
void check_terrain(const Scenario& scenario);

}  // namespace coupling
