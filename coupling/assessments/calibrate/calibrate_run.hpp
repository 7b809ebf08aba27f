#pragma once

#include "coupling/run/ranks.hpp"
#include "coupling/run/run_request.hpp"

namespace coupling::calibrate {

/// Fits what is not known of ground and trees to what section [observed] names, and writes the parameter sets
/// that agree with it. Ranks share the sets. `request.out` empty: `calibration` beside the scenario file.
///
/// Returns 0, or 75 if the user interrupted it; the same call goes on from there. Throws config::InputError.
int run_calibration(RunRequest request, RankGroup& ranks);

}  // namespace coupling::calibrate
