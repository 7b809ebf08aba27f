#pragma once

#include <optional>
#include <string>

#include "coupling/assessments/decades/report/decade_page.hpp"
#include "coupling/assessments/decades/report/series.hpp"
#include "coupling/results/templates/page_template.hpp"

namespace coupling::decades {

// The parts of decade_page.html: the fields of each.

/// What was run: a sentence and facts.
report::PageFields page_opening(const PageContent& content, const RunView& run);
/// Start, middle and end of what stands, and what came and went.
report::PageFields answers_of(const RunView& run);
/// Each figure over the years with a line for each regime; nothing without years.
std::optional<report::PageFields> charts_of_regimes(const RunView& run);
/// Species, causes of loss and diameters: a chart for each regime, in blocks; nothing without regimes.
std::optional<report::PageFields> charts_by_regime(const PageContent& content, const RunView& run);
/// The stand from above and from the side in the first and the last year with a list of trees; nothing
/// without one.
std::optional<report::PageFields> pictures(const PageContent& content, const RunView& run);
/// Where rocks pass, how hard, and what the forest changes: maps of chosen years for each regime; nothing
/// without such.
std::optional<report::PageFields> maps_of_falls(const PageContent& content, const RunView& run);
/// The slope with the trees of each regime and year in three dimensions, as HTML; empty without lists of
/// trees.
std::string view_of_years(const PageContent& content, const RunView& run);

/// What the page adds to the style of all reports: the fills, and years.css.
std::string page_style();

// Colours with patterns, so that areas differ without colour too.

/// Fills that drawings refer to. Once on a page, before the first drawing.
std::string fill_definitions();
/// The class of a species' fill: the same in every run that keeps the order of the species table.
std::string fill_of_species(std::size_t species);
std::string fill_of_cause(forest::Cause cause);
/// The class of a regime's line.
std::string line_of_regime(std::size_t place);

}  // namespace coupling::decades
