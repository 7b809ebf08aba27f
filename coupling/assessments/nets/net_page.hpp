#pragma once

#include <string>

#include "coupling/results/figures/run_results.hpp"
#include "coupling/results/report/map/map_window.hpp"

namespace coupling::report {

/// The section of the page about nets: for each its developed view, histograms and key figures, and where
/// paths are kept maps on which it can be moved; empty without nets. `shown`: of the maps of the page.
std::string nets(const RunResults& results, const MapWindow& shown);

/// Whether that section has nets that can be moved.
bool has_moving_nets(const RunResults& results);

}  // namespace coupling::report
