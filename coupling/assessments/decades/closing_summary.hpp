#pragma once

#include "coupling/assessments/decades/decade_results.hpp"

namespace coupling::decades {

/// The answer of the run in a few lines to stdout.
void print_summary(const DecadeResults& results);

}  // namespace coupling::decades
