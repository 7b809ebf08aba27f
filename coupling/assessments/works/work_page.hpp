#pragma once

#include <string>
#include <utility>
#include <vector>

#include "coupling/assessments/works/work_figures.hpp"
#include "coupling/inputs/works/work_record.hpp"
#include "coupling/results/figures/run_results.hpp"

namespace coupling::report {

/// What may become of rocks at a work of a kind, in the order of the page.
std::vector<std::pair<WorkOutcome, std::string>> outcomes_in_words(WorkKind kind);

/// The section of the page about dams, ditches, walls and galleries; empty without any.
std::string works(const RunResults& results);

}  // namespace coupling::report
