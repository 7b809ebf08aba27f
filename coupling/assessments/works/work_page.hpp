#pragma once

#include <string>

#include "coupling/results/figures/run_results.hpp"

namespace coupling::report {

/// The section of the page about dams, ditches, walls and galleries; empty without any.
std::string works(const RunResults& results);

}  // namespace coupling::report
