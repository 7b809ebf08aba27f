#pragma once

#include <string>
#include <vector>

#include "validation/engine/case/case_files.hpp"
#include "validation/engine/case/comparison.hpp"
#include "validation/engine/field/field_case.hpp"

namespace coupling::validation {

/// One scenario in several states, such as a forest before and after a windthrow: what changes from state to
/// state is held against published changes (observed.csv).
///
/// `states.csv` has `state`, `overrides` (settings apart by blanks) and `meaning`; the first state is what
/// the others are compared with. Figures: `run_out_mean_m:STATE`, `run_out_change_percent:STATE` and, where
/// the scenario has targets, `passing_percent:STATE`, the share of rocks that reach the first of them.
Comparison read_states(const CaseFiles& files, const FieldSettings& settings,
                       const std::vector<std::string>& overrides);

}  // namespace coupling::validation
