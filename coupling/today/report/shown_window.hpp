#pragma once

#include "coupling/results/report/map_window.hpp"
#include "coupling/results/run_results.hpp"

namespace coupling::report {

/// The part of the map that the page shows: where rocks go on either slope, and where they start.
MapWindow shown_window(const RunResults& results);

}  // namespace coupling::report
