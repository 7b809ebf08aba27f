#pragma once

#include <string>

#include "coupling/assessments/decades/decision/decision.hpp"

namespace coupling::decades {

/// Verdict and table of all regimes and climates, as HTML: the first part of the page.
std::string decision_html(const Names& names, const Decision& decision);

}  // namespace coupling::decades
