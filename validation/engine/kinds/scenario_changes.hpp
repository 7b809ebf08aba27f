#pragma once

#include "validation/engine/kinds/validation_case.hpp"

namespace coupling::validation {

/// The options of `bannwald validate` for a case that is a scenario with a terrain: the seed is that of the
/// scenario, --rocks changes nothing (a note says so). Throws InputError (settings) for --profile.
void take_changes_of_a_scenario(ValidationCase& out);

}  // namespace coupling::validation
