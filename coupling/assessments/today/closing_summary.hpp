#pragma once

#include "coupling/results/figures/run_results.hpp"

namespace coupling {

/// The answer of the run in a few lines to stdout.
void print_summary(const RunResults& results);

}  // namespace coupling
