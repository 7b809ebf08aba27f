#pragma once

#include <span>
#include <string>

#include "coupling/assessments/compare/runs/side_by_side.hpp"
#include "coupling/results/report/chart.hpp"

namespace coupling::compare {

// The parts of the page, each a piece of HTML, empty where there is nothing to show.

/// Looks of a run's lines in charts: "run0", "run1", ... (compare.css); eight, then again.
std::string look_of(std::size_t run);

/// The main figures as dots with their intervals, a chart for each target and quantity.
std::string interval_charts(const SideBySide& comparison);
/// Energies, speeds and heights at the targets, and run-outs: shares of all rocks.
std::string distributions(std::span<const FinishedRun> runs, const SideBySide& comparison);
/// Main quantities over the years, a chart for each regime.
std::string charts_over_years(std::span<const FinishedRun> runs, const SideBySide& comparison);
/// Rasters of today's runs side by side, in common colours.
std::string maps(std::span<const FinishedRun> runs, const SideBySide& comparison);

}  // namespace coupling::compare
