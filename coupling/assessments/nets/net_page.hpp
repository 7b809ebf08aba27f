#pragma once

#include <string>

#include "coupling/results/figures/run_results.hpp"

namespace coupling::report {

/// The section of the page about nets: for each its developed view, histograms and key figures; empty without
/// nets.
std::string nets(const RunResults& results);

}  // namespace coupling::report
