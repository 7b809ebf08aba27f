#pragma once

#include "coupling/assessments/calibrate/model/observations.hpp"

namespace coupling::calibrate {

/// What of the rocks of a set could have been seen as `observation`.
Sample seen_of(const SetRocks& rocks, const Observation& observation, const Search& search);

}  // namespace coupling::calibrate
