#pragma once

#include <string>
#include <vector>

#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/figures/run_results.hpp"

namespace coupling::report {

// The parts of the page, each a piece of HTML.

/// Why a run has neither trees nor logs: none were given, or none of those given is left.
std::string why_no_obstacles(const RunResults& results);
/// The first screen: question, answer, maps of the energies, what decides them, warnings.
std::string first_screen(const RunResults& results, const Figures& figures);
/// Share of rocks that reach each target and what the forest stops, in a few words.
std::string answers(const RunResults& results, const Figures& figures);
/// What arrives at each target in figures: energies and heights, how sure they are.
std::string answers_in_detail(const RunResults& results, const Figures& figures);
/// What all maps refer to, and the maps of the first screen.
std::string first_maps(const RunResults& results);
/// What arrives along each line, by stretches.
std::string along_lines(const RunResults& results);
/// What arrives by release zone and by block size.
std::string release_groups(const RunResults& results);
/// Stems, basal area, diameters, gaps and target profile of the trees as they stand, and which of them take
/// the energy.
std::string forest_of_today(const RunResults& results);
/// Ground, trees, sampled paths and targets in three dimensions.
std::string slope_view(const RunResults& results);
std::string maps(const RunResults& results);
std::string charts(const RunResults& results, const Figures& figures);
/// Energy and height along some of the sampled paths.
std::string along_paths(const RunResults& results);
/// All rocks on both slopes.
std::string key_figures(const RunResults& results, const Figures& figures);
/// The ground types that occur, with what the motion model uses of them.
std::string grounds(const RunResults& results);
/// Observed stops beside simulated ones; nothing where none were observed.
std::string observed_stops(const std::vector<observed::StopComparison>& comparisons);
/// Observed passages and impacts beside simulated ones; nothing where none were observed.
std::string observed_events(const std::vector<observed::EventComparison>& comparisons);
std::string warnings(const RunResults& results);
/// Settings that differ from their defaults; all of them folded.
std::string settings(const RunResults& results);
/// Input files with hashes, projection, files written, how to cite.
std::string sources_and_files(const RunResults& results, const std::vector<WrittenFile>& files);

}  // namespace coupling::report
