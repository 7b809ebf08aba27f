#pragma once

namespace coupling {

struct Scenario;

/// Reads the heights of a scenario alone. Throws config::InputError where they make no terrain that could be
/// meant, for whatever rocks.
void check_terrain(const Scenario& scenario);

}  // namespace coupling
