#pragma once

#include <string>

#include "coupling/inputs/scenario/report_settings.hpp"
#include "coupling/results/figures/read_summary.hpp"

namespace coupling::report {

/// The setting of a finished run; empty where its summary has none of this key.
std::string setting_of(const SummaryOfRun& run, const std::string& key);

/// What stands over a page about a finished run: its [report] without the logo, whose file may be elsewhere
/// now.
ReportSettings head_of_run(const SummaryOfRun& run);

}  // namespace coupling::report
