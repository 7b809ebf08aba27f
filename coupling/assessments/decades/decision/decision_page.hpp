#pragma once

#include <string>

#include "coupling/assessments/decades/decision/decision.hpp"

namespace coupling::decades {

/// Verdict, table of all regimes and climates, and `charts` of their protection, as HTML: the first part of
/// the page.
std::string decision_html(const Names& names, const Decision& decision, const std::string& charts);

}  // namespace coupling::decades
