#pragma once

#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "validation/engine/case/case_result.hpp"
#include "validation/engine/kinds/validation_case.hpp"

namespace coupling::validation {

/// The verdicts of cases as Markdown: a table for each case, then its misses. validation/VERDICTS.md shows
/// this text between these lines.
inline constexpr std::string_view summary_begins = "<!-- written by bannwald validate all: summary.md -->";
inline constexpr std::string_view summary_ends = "<!-- end of summary.md -->";

void write_summary(std::ostream& out, std::span<const CaseResult> cases);

/// One row a case: how many criteria it meets. The root README shows this text between these lines.
inline constexpr std::string_view overview_begins = "<!-- written by bannwald validate all: overview.md -->";
inline constexpr std::string_view overview_ends = "<!-- end of overview.md -->";

void write_overview(std::ostream& out, std::span<const CaseResult> cases);

/// The cells of a line of the summary that its case's folder fixes: figure, unit, observed, published,
/// criterion. They can be compared without letting a rock fall.
std::vector<std::string> fixed_cells(const VerdictRow& row);

}  // namespace coupling::validation
