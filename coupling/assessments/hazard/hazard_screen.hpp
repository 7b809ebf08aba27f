#pragma once

#include "coupling/assessments/hazard/hazard_results.hpp"

namespace coupling::hazard {

/// What the hazard map and the risk say, for the terminal.
void print_summary(const HazardResults& results);

}  // namespace coupling::hazard
