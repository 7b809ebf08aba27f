#pragma once

#include <string>

#include "coupling/assessments/decades/report/decade_page.hpp"
#include "coupling/assessments/decades/report/series.hpp"

namespace coupling::decades {

// The parts of the page, each a piece of HTML.

/// What was run: a sentence and facts.
std::string page_opening(const PageContent& content, const RunView& run);
/// Start, middle and end of what stands, and what came and went.
std::string answers(const RunView& run);
/// Each figure over the years with a line for each regime.
std::string charts_of_regimes(const RunView& run);
/// Species, causes of loss and diameters: a chart for each regime.
std::string charts_by_regime(const PageContent& content, const RunView& run);
/// The stand from above and from the side in the first and the last year with a list of trees; empty without
/// one.
std::string pictures(const PageContent& content, const RunView& run);
/// The slope with the trees of each regime and year in three dimensions; empty without lists of trees.
std::string view_of_years(const PageContent& content, const RunView& run);
/// Where rocks pass, how hard, and what the forest changes: maps of chosen years for each regime; empty
/// without such.
std::string maps_of_falls(const PageContent& content, const RunView& run);

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
