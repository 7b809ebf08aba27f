#pragma once

#include <string>
#include <vector>

#include "coupling/results/figures.hpp"
#include "coupling/results/out_file.hpp"
#include "coupling/results/run_results.hpp"

namespace coupling::report {

// The parts of the page, each a piece of HTML.

/// Why a run has neither trees nor logs: none were given, or none of those given is left.
std::string why_no_obstacles(const RunResults& results);
/// What was run, in one paragraph and a few figures.
std::string opening(const RunResults& results, const Figures& figures);
/// Share of rocks that reach each target, what the forest stops, energies and heights there.
std::string answers(const RunResults& results, const Figures& figures);
/// Ground, trees, sampled paths and targets in three dimensions.
std::string slope_view(const RunResults& results);
std::string maps(const RunResults& results);
std::string charts(const RunResults& results, const Figures& figures);
/// Energy and height along some of the sampled paths.
std::string along_paths(const RunResults& results);
/// All rocks on both slopes, and the trees by diameter.
std::string key_figures(const RunResults& results, const Figures& figures);
/// The ground types that occur, with what the motion model uses of them.
std::string grounds(const RunResults& results);
/// Observed stops beside simulated ones; nothing where none were observed.
std::string observed_stops(const std::vector<observed::StopComparison>& comparisons);
/// Observed passages and impacts beside simulated ones; nothing where none were observed.
std::string observed_events(const std::vector<observed::EventComparison>& comparisons);
std::string warnings(const RunResults& results);
std::string settings(const RunResults& results);
/// Input files with hashes, projection, files written, how to cite.
std::string sources_and_files(const RunResults& results, const std::vector<WrittenFile>& files);

}  // namespace coupling::report
