#pragma once

#include "validation/engine/kinds/validation_case.hpp"

namespace coupling::validation {

/// Reads the files of a case of the forest, whose kind is known: head, comparison, notes and warnings. What
/// changes rocks alone is left out with a note. Throws InputError.
void read_forest(ValidationCase& out);

}  // namespace coupling::validation
