#pragma once

#include "coupling/results/figures/run_results.hpp"
#include "coupling/results/report/map/map_window.hpp"

namespace coupling::report {

/// The part of the map that the page shows: where rocks go on either slope, and where they start.
MapWindow shown_window(const RunResults& results);

}  // namespace coupling::report
