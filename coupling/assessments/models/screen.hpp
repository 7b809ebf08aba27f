#pragma once

#include <ostream>

#include "coupling/assessments/models/figures/comparison.hpp"

namespace coupling::models {

/// For people: of each target, net and slope the main figures with their range over the models, whether
/// these disagree, and which is judged best.
void print_ranges(std::ostream& out, const Comparison& comparison);

}  // namespace coupling::models
