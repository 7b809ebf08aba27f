#pragma once

#include <span>
#include <string>

#include "coupling/assessments/decades/decision/decision.hpp"
#include "coupling/assessments/decades/decision/decision_risk.hpp"

namespace coupling::decades {

/// Verdict and table of all regimes and climates, with the risk of each course where it is assessed, as HTML:
/// the first part of the page.
std::string decision_html(const Names& names, const Decision& decision,
                          std::span<const CourseRisk> risks = {});

}  // namespace coupling::decades
