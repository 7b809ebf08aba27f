#pragma once

#include <filesystem>
#include <span>

#include "coupling/assessments/nets/figures/net_figures.hpp"
#include "coupling/assessments/nets/figures/net_paths.hpp"
#include "coupling/inputs/scenario/report_settings.hpp"
#include "coupling/run/short_run.hpp"

namespace coupling {

/// What summary.json of `net try` and `net place` says of the run whose paths they read.
Json run_of_paths(const std::filesystem::path& run, const std::filesystem::path& nets, const PathsHead& head);

/// What pages about a finished run say at their head: section [report] of that run.
ReportSettings head_of(const std::filesystem::path& run);

/// A title of a page about stored paths, with the return period of their rocks where they have one.
std::string title_with_period(const std::string& title, const PathsHead& head);

Json json_of(const NetQuantity& quantity);

/// Figures of nets on all slopes.
Json json_of(std::span<const NetRecord> nets, std::span<const NetFigures> figures);

/// The decimal sign of tables for Excel where that run wrote such ones.
std::optional<char> excel_decimal_of(const PathsHead& head);

}  // namespace coupling
