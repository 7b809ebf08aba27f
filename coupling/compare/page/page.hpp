#pragma once

#include <ostream>
#include <span>

#include "coupling/compare/side_by_side.hpp"

namespace coupling::compare {

/// The comparison as one self-contained HTML page: what differs, figures with intervals, distributions at the
/// targets and maps (runs of today) or protection over the years, in the same axes and colours for all runs.
/// Throws config::InputError for tables and rasters of a run that are missing or not its own.
void write_page(std::ostream& out, std::span<const FinishedRun> runs, const SideBySide& comparison);

}  // namespace coupling::compare
