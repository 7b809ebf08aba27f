#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coupling/results/figures/figures.hpp"
#include "coupling/results/figures/run_results.hpp"
#include "coupling/results/templates/page_template.hpp"

namespace coupling::report {

// What the parts of today_page.html are filled with, in the order of the page.

/// Why a run has neither trees nor logs: none were given, or none of those given is left. Text, not markup.
std::string why_no_obstacles(const RunResults& results);
/// A title of the page with the return period where the run is one of a hazard map.
std::string with_return_period(const std::string& title, const Scenario& scenario);
/// The question, what decides the answer, warnings, where rocks leave the terrain.
PageFields opening(const RunResults& results);
/// Share of rocks that reach each target and what the forest stops, in a few words.
PageFields answers(const RunResults& results, const Figures& figures);
/// Both 95 % intervals of the main figures, and what brings the second one; nothing where nothing was drawn.
std::optional<PageFields> two_intervals(const RunResults& results, const Figures& figures);
/// The interval of all that is not known at a target, for its card.
std::optional<PageFields> answer_with_all(const RunResults& results, const Figures& figures,
                                          std::size_t target);
/// What all maps refer to, the maps of the first screen, and all others.
PageFields maps(const RunResults& results);
/// What arrives along each line, by stretches.
std::optional<PageFields> along_lines(const RunResults& results);
/// What arrives by release zone and by block size.
PageFields release_groups(const RunResults& results);
/// The barrier that the rocks at each target ask for; nothing unless design.rule asks for it.
std::optional<PageFields> target_barriers(const RunResults& results);
/// Stems, basal area, diameters, gaps and target profile of the trees as they stand, and which of them take
/// the energy.
std::optional<PageFields> forest_of_today(const RunResults& results);
/// Ground, trees, sampled paths and targets in three dimensions: ready HTML.
std::string slope_view(const RunResults& results);
/// What arrives at each target in figures: energies and heights, how sure they are.
std::optional<PageFields> answers_in_detail(const RunResults& results, const Figures& figures);
PageFields charts(const RunResults& results, const Figures& figures);
/// Observed stops beside simulated ones; nothing where none were observed.
std::optional<PageFields> observed_stops(const std::vector<observed::StopComparison>& comparisons);
/// Observed passages and impacts beside simulated ones; nothing where none were observed.
std::optional<PageFields> observed_events(const std::vector<observed::EventComparison>& comparisons);
/// Energy and height along some of the sampled paths.
std::optional<PageFields> single_paths(const RunResults& results);
/// Chosen blocks with a shape and the mean of all sampled ones over time; nothing under other models.
std::optional<PageFields> paths_over_time(const RunResults& results);
/// All rocks on both slopes.
PageFields key_figures(const RunResults& results, const Figures& figures);
/// The ground types that occur, with what the motion model uses of them.
PageFields grounds(const RunResults& results);

}  // namespace coupling::report
