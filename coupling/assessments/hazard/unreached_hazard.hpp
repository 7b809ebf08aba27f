#pragma once

#include "config/errors/warnings.hpp"
#include "coupling/assessments/hazard/hazard_results.hpp"

namespace coupling::hazard {

/// Says which targets no rock of any return period reaches on any slope, with the likely reason.
void warn_of_unreached(const HazardResults& results, config::Warnings& warnings);

}  // namespace coupling::hazard
