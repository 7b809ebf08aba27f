#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "coupling/assessments/compare/page/shown_targets.hpp"
#include "coupling/assessments/compare/runs/side_by_side.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/templates/page_template.hpp"

namespace coupling::compare {

// The parts of compare_page.html, nothing where there is nothing to show.

/// Looks of a run's lines in charts: "run0", "run1", ... (compare.css); eight, then again.
std::string look_of(std::size_t run);

/// Fields under one name, if there are any.
template <class Content>
std::optional<report::PageFields> part_if_any(const char* name, const Content& content) {
    return content.empty() ? std::nullopt : std::optional{report::PageFields{{name, content}}};
}

/// "With forest" or "Bare slope", by the name of a folder of rasters.
const std::string& slope_title(std::string_view cover);

/// The main figures as dots with their intervals, a chart for each shown target and quantity.
std::optional<report::PageFields> interval_charts(const SideBySide& comparison, const ShownTargets& charted);
/// Energies, speeds and heights at the shown targets, and run-outs: shares of all rocks.
std::optional<report::PageFields> distributions(std::span<const FinishedRun> runs,
                                                const SideBySide& comparison, const ShownTargets& charted);
/// Main quantities over the years, a chart for each regime.
std::optional<report::PageFields> charts_over_years(std::span<const FinishedRun> runs,
                                                    const SideBySide& comparison);
/// Rasters of today's runs side by side, in common colours.
std::optional<report::PageFields> maps(std::span<const FinishedRun> runs, const SideBySide& comparison);

}  // namespace coupling::compare
