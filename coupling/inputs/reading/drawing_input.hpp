#pragma once

#include "coupling/inputs/reading/reading.hpp"

namespace coupling {

/// Records run.drawing as an input, whatever is drawn in it, and notes which of its layers hold nothing yet
/// and what the run does without them.
void note_drawing(Reading& reading);

}  // namespace coupling
