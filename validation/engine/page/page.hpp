#pragma once

#include <ostream>
#include <span>

#include "validation/engine/case/case_result.hpp"

namespace coupling::validation {

/// The cases as one self-contained HTML page: no script, no outside address, same bytes from the same
/// results. Opens with the criteria met and missed; then for each case its verdicts, plots, variants side by
/// side, and its free choices moved.
void write_validation_page(std::ostream& out, std::span<const CaseResult> cases);

}  // namespace coupling::validation
