#pragma once

#include <ostream>
#include <string>

#include "validation/engine/case/case_result.hpp"

namespace coupling::validation {

/// A figure as people read it: three figures or so, three decimals for shares; "-" for none. A deviation has
/// the decimals of its value.
std::string figure_text(double value, const std::string& unit);
std::string figure_text(double value, double deviation, const std::string& unit);

/// " r" behind a criterion that was used to rebuild the slope, " f" behind one that the model was fitted to.
std::string mark_of(const VerdictRow& row);

/// The outcome of a case on a screen of 110 columns: the table of verdicts, the misses with their causes, and
/// the verdicts that moved choices change.
void print_case(std::ostream& out, const CaseResult& result);

}  // namespace coupling::validation
