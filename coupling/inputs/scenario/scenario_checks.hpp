#pragma once

namespace coupling {

struct Scenario;

/// What no single setting shows: inputs that are missing or exclude each other, lists that do not match.
/// Throws InputError (settings) with all of it.
void check(const Scenario& scenario);

}  // namespace coupling
