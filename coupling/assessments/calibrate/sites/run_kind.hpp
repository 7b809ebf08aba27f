#pragma once

#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site.hpp"

namespace coupling::calibrate {

/// A calibration lets the rocks of one event fall today, by what is known of them. Throws InputError
/// (settings) for scenarios of other runs.
void refuse_other_runs(const Scenario& scenario);

/// A sample is a result, not a beginning. Throws InputError (settings).
void refuse_samples(const Scenario& scenario, const Site& site);

}  // namespace coupling::calibrate
