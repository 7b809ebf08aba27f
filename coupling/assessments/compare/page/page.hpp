#pragma once

#include <optional>
#include <ostream>
#include <span>

#include "config/text/language.hpp"
#include "coupling/assessments/compare/runs/side_by_side.hpp"

namespace coupling::compare {

/// The comparison as one self-contained HTML page: what differs, figures with intervals, distributions at the
/// targets and maps (runs of today) or protection over the years, in the same axes and colours for all runs.
/// Throws config::InputError for tables and rasters of a run that are missing or not its own.
/// Without a language in that of the first run.
void write_page(std::ostream& out, std::span<const FinishedRun> runs, const SideBySide& comparison,
                std::optional<config::Language> language);

}  // namespace coupling::compare
